#include "study/dose/dose_report.h"

#include <exception>
#include <memory>
#include <utility>

#include "base/exceptions.h"
#include "study/dose/found_dose.h"
#include "study/segmentation/found_segmentation.h"
#include "study/segmentation/loaded_segmentation.h"

namespace macula::study {

namespace {

Error notInOneFrame() {
    return {ErrorCode::inputNotUsable,
            Text("The dose lies in another coordinate system (frame of reference) than the volume."),
            {},
            Text("Choose the images that the treatment was planned on.")};
}

Error noRegions() {
    return {ErrorCode::inputNotUsable,
            Text("There is no structure set or segmentation of this volume."),
            {},
            Text("Put the structure set (RTSTRUCT) of the plan into the folder.")};
}

Result<void> addRegions(const FoundSegmentation& found, const DoseOnVolume& of, const DoseField& field,
                        DoseReport& report, Progress& progress) {
    MACULA_TRY(const std::shared_ptr<const LoadedSegmentation> loaded,
               loadSegments(found, of.grid, *of.found.volumes().at(of.on).stack, progress));
    report.notes.insert(report.notes.end(), loaded->notes.begin(), loaded->notes.end());
    progress.beginStage(Text("Computing the dose in {} regions", loaded->segments.size()),
                        loaded->segments.size());
    for (const LoadedSegment& segment : loaded->segments) {
        RegionInDose region{.set = found.title,
                            .label = segment.segment.label,
                            .rgb = usualRgb(segment.segment),
                            .volumeMl = segment.volumeMl,
                            .dose = {}};
        if (segment.voxels) {
            MACULA_TRY(region.dose, doseIn(*segment.voxels, of.grid.worldFromVoxel(), field, progress));
        }
        report.regions.push_back(std::move(region));
        progress.advance();
    }
    return {};
}

// What no single row tells.
void addNotes(DoseReport& report) {
    std::size_t partly = 0;
    std::size_t divided = 0;
    for (const RegionInDose& region : report.regions) {
        partly += region.dose.outside > 0 ? 1 : 0;
        divided += region.dose.samples > region.dose.voxels ? 1 : 0;
    }
    if (partly > 0)
        report.notes.push_back(
            Text("{} regions lie partly or wholly outside the dose: figures are of the part "
                 "inside.",
                 partly));
    if (divided > 0)
        report.notes.push_back(
            Text("The voxels of {} regions were divided, because they are few, or larger than "
                 "those of the dose.",
                 divided));
    if (report.reference && report.reference->of == DoseReference::Of::maximum)
        report.notes.push_back(
            Text("No prescription is known: percentages are of the highest dose, {:.4g} {}.",
                 report.reference->value, report.unit));
}

}  // namespace

std::optional<DoseReference> usualReference(const std::optional<dicom::DoseFacts>& facts,
                                            const Volume& dose) {
    if (facts) {
        if (const auto gy = facts->prescribedGy())
            return DoseReference{.value = *gy, .of = DoseReference::Of::prescription};
    }
    if (!dose.valueRange() || !(dose.valueRange()->high > 0.0)) return std::nullopt;
    return DoseReference{.value = dose.valueRange()->high, .of = DoseReference::Of::maximum};
}

Result<DoseReport> reportDose(const DoseOnVolume& of, Progress& progress) try {
    const FoundVolume& on = of.found.volumes().at(of.on);
    const FoundVolume& dose = of.found.volumes().at(of.dose);
    const std::string frame = frameOfReferenceOf(*dose.stack);
    const bool areOfOne = dicom::mayBeOnePatient(of.found.scan(), on.study->patient, dose.study->patient);
    if (frame.empty() || frameOfReferenceOf(*on.stack) != frame || !areOfOne) return notInOneFrame();
    DoseReport report;
    report.unit = of.values->unitName();
    const std::optional<dicom::DoseFacts> facts = dicom::doseFactsOf(of.found.scan(), *dose.stack);
    report.isInGy = facts && facts->isInGy();
    report.reference = usualReference(facts, *of.values);
    if (facts) report.notes = doseNotes(*facts);
    MACULA_TRY(const std::vector<FoundSegmentation> sets, findSegmentations(of.found, on, progress));
    const DoseField field(of.values);
    for (const FoundSegmentation& set : sets) {
        if (!set.canBeShown()) continue;
        MACULA_TRY_VOID(addRegions(set, of, field, report, progress));
    }
    if (report.regions.empty()) return noRegions();
    addNotes(report);
    return report;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("compute the dose in regions"));
}

}  // namespace macula::study
