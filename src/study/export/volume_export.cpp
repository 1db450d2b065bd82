#include "study/export/volume_export.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/elapsed.h"
#include "base/english.h"
#include "base/sha256.h"
#include "dicom/read/sop_class.h"
#include "dicom/segmentation/segmentation.h"
#include "study/export/grid_json.h"

namespace macula::study {

namespace {

std::vector<const dicom::OtherObject*> segmentationsOf(const dicom::Series& series) {
    std::vector<const dicom::OtherObject*> found;
    for (const dicom::OtherObject& object : series.objects) {
        if (dicom::isSegmentation(object.sopClassUid)) found.push_back(&object);
    }
    return found;
}

// Loads the segmentation on the first grid that it fits; several stacks of a series may share one.
Result<SegmentationOnGrid> onItsGrid(const dicom::Scan& scan, const dicom::Segmentation& segmentation,
                                     Progress& progress) {
    bool hasImages = false;
    for (const std::string& uid : segmentation.referencedSeriesUids) {
        for (const dicom::Series* series : dicom::findAllSeries(scan, uid)) {
            for (const dicom::Stack& stack : series->stacks) {
                if (!stack.canBeVolume()) continue;
                const glm::ivec3 size(stack.columns, stack.rows, static_cast<int>(stack.slices.size()));
                hasImages = true;
                const std::vector<glm::dvec3> positionsMm = dicom::slicePositionsMm(stack);
                auto map =
                    dicom::loadSegmentation(segmentation, *stack.worldFromVoxel, size, progress, positionsMm);
                if (map) return SegmentationOnGrid{std::move(*map), true, true};
                if (map.error().code != ErrorCode::inputNotUsable) return map.error();
            }
        }
    }
    MACULA_TRY(LabelMap map, dicom::loadSegmentation(segmentation, progress));
    return SegmentationOnGrid{std::move(map), false, hasImages};
}

}  // namespace

void noteWhatOthersMisread(LoadedStudy& study) {
    if (!isSheared(study.volume->worldFromVoxel())) return;
    study.notes.push_back(Text(
        "The slices are tilted against their axis, and the file says so; some programs do not understand "
        "that, and show the patient askew."));
    study.warnings.push_back(study.notes.back());
}

Result<ExportedVolume> exportVolume(const LoadedStudy& study, const std::filesystem::path& file,
                                    Progress& progress) {
    const Volume& volume = *study.volume;
    ExportedVolume exported{.seriesDigest = study.seriesDigest,
                            .unit = volume.unitName(),
                            .valueRange = volume.valueRange(),
                            .worldFromVoxel = volume.worldFromVoxel(),
                            .notes = study.notes};
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY_VOID(formats::writeVolumeFile(volume, file, progress));
    exported.writeSeconds = secondsSince(start);
    MACULA_TRY(exported.file, formats::readVolumeFileInfo(file));
    return exported;
}

nlohmann::ordered_json toJson(const ExportedVolume& exported, double loadSeconds) {
    nlohmann::ordered_json json = {{"version", MACULA_VERSION},
                                   {"series", exported.seriesDigest},
                                   {"format", exported.file.format},
                                   {"values", exported.file.values},
                                   {"unit", exported.unit}};
    json.update(gridToJson(exported.file.size, exported.worldFromVoxel));
    json["sheared"] = isSheared(exported.worldFromVoxel);
    if (const auto& range = exported.valueRange) json["valueRange"] = {range->low, range->high};
    json["loadSeconds"] = loadSeconds;
    json["writeSeconds"] = exported.writeSeconds;
    json["notes"] = inEnglish(exported.notes);
    return json;
}

std::vector<Text> notesOf(const SegmentationOnGrid& input) {
    std::vector<Text> notes;
    if (!input.onItsSeries) {
        notes.push_back(
            input.hasImages
                ? Text("It does not lie on the voxels of the images it was drawn on: it is on a grid of its "
                       "own.")
                : Text("The images it was drawn on are not there: it is on a grid of its own."));
    }
    for (const Message& message : input.map.messages()) notes.push_back(message.sentence);
    return notes;
}

Result<ExportedSegmentation> exportSegmentation(const SegmentationOnGrid& input, const std::string& seriesUid,
                                                const std::filesystem::path& file, Progress& progress) {
    const LabelMap& map = input.map;
    ExportedSegmentation exported{.seriesDigest = sha256Hex(seriesUid),
                                  .size = map.size(),
                                  .worldFromVoxel = map.worldFromVoxel(),
                                  .segments = {},
                                  .notes = notesOf(input)};
    MACULA_TRY_VOID(formats::writeVolumeFile(map, file, progress));
    for (const Segment& segment : map.segments())
        exported.segments.push_back(
            {.number = segment.number,
             .label = segment.label,
             .voxels = std::count(map.labels().begin(), map.labels().end(), segment.number)});
    return exported;
}

nlohmann::ordered_json toJson(const ExportedSegmentation& exported) {
    nlohmann::ordered_json segments = nlohmann::ordered_json::array();
    for (const ExportedSegment& segment : exported.segments)
        segments.push_back(
            {{"number", segment.number}, {"label", segment.label}, {"voxels", segment.voxels}});
    nlohmann::ordered_json json = {
        {"version", MACULA_VERSION}, {"series", exported.seriesDigest}, {"segments", std::move(segments)}};
    json.update(gridToJson(exported.size, exported.worldFromVoxel));
    json["notes"] = inEnglish(exported.notes);
    return json;
}

bool isSegmentationSeries(const dicom::Series& series) {
    return series.stacks.empty() && !segmentationsOf(series).empty();
}

Result<SegmentationOnGrid> loadSegmentation(const dicom::Scan& scan, const dicom::Series& series,
                                            std::size_t number, Progress& progress) {
    const auto all = segmentationsOf(series);
    if (number == 0 && all.size() > 1) {
        return Error{ErrorCode::usage,
                     Text("The series has {} segmentations.", all.size()),
                     {},
                     Text("Choose one of them with --volume.")};
    }
    if (number > all.size()) {
        return Error{ErrorCode::usage,
                     Text("There is no segmentation {}; the series has {}.", number, all.size()),
                     {},
                     Text("Choose another with --volume.")};
    }
    MACULA_TRY(const dicom::Segmentation segmentation,
               dicom::readSegmentation(all[std::max<std::size_t>(number, 1) - 1]->file));
    return onItsGrid(scan, segmentation, progress);
}

}  // namespace macula::study
