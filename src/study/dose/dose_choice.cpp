#include "study/dose/dose_choice.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "study/dose/found_dose.h"
#include "study/open/opened_study.h"

namespace macula::study {

namespace {

bool isDose(const FoundVolume& volume) {
    return volume.series->modality == "RTDOSE";
}

// Of those that a dose lies on; nothing if there is none.
std::optional<std::size_t> largestWithDose(const FoundVolumes& found) {
    std::optional<std::size_t> largest;
    double most = 0.0;
    for (std::size_t i = 0; i < found.volumes().size(); ++i) {
        const dicom::Stack& stack = *found.volumes()[i].stack;
        const double voxels = double(stack.columns) * stack.rows * double(stack.frames.size());
        if (voxels <= most || dosesOn(found, i).empty()) continue;
        most = voxels;
        largest = i;
    }
    return largest;
}

}  // namespace

Result<ChosenDose> chooseDose(const FoundVolumes& found, const std::filesystem::path& folder,
                              const std::string& series, const std::string& dose) {
    const auto& volumes = found.volumes();
    const auto first = std::ranges::find_if(volumes, isDose);
    if (first == volumes.end())
        return Error{ErrorCode::inputNotUsable,
                     Text("The folder has no dose (RTDOSE) that can be read as a volume."), folder.string(),
                     Text("Put the dose of the plan into the folder.")};
    std::optional<std::size_t> on;
    if (!series.empty()) {
        MACULA_TRY(const FoundVolumes::ChosenVolume meant, found.ofSeries(series, folder));
        on = meant.index;
    } else {
        on = largestWithDose(found);
    }
    if (!dose.empty()) {
        MACULA_TRY(const FoundVolumes::ChosenVolume meant, found.ofSeries(dose, folder));
        if (!isDose(volumes[meant.index]))
            return Error{ErrorCode::usage, Text("The series is no dose."), dose,
                         Text("Choose one of the modality RTDOSE in the list of macula info.")};
        return ChosenDose{.on = on.value_or(meant.index), .dose = meant.index};
    }
    const auto firstDose = std::size_t(first - volumes.begin());
    if (!on) return ChosenDose{.on = firstDose, .dose = firstDose};
    const std::vector<FoundDose> doses = dosesOn(found, *on);
    if (doses.empty())
        return Error{
            ErrorCode::inputNotUsable,
            Text("No dose of the folder lies in the coordinate system (frame of reference) of the volume."),
            folder.string(), Text("Choose the images that the treatment was planned on.")};
    ChosenDose chosen{.on = *on, .dose = doses.front().volume};
    if (doses.size() > 1)
        chosen.notes.push_back(
            Text("{} doses lie on the volume. The figures are of one of them; --dose chooses another.",
                 doses.size()));
    return chosen;
}

Result<DoseReport> reportDose(const std::shared_ptr<const FoundVolumes>& found, const ChosenDose& chosen,
                              Progress& progress) {
    MACULA_TRY(const OpenedStudy dose, openFoundVolume(found, chosen.dose, progress));
    OpenedStudy on = dose;
    std::vector<Text> notes = chosen.notes;
    if (chosen.on != chosen.dose) {
        MACULA_TRY(on, openFoundVolume(found, chosen.on, progress));
    } else {
        notes.push_back(
            Text("No images lie in the coordinate system of the dose: regions are drawn on its grid."));
    }
    if (dose.dose) notes.push_back(Text("{}.", doseText(*dose.dose)));
    MACULA_TRY(DoseReport report, reportDose({.found = *found,
                                              .on = chosen.on,
                                              .grid = *on.volume,
                                              .dose = chosen.dose,
                                              .values = dose.measured()},
                                             progress));
    report.notes.insert(report.notes.begin(), notes.begin(), notes.end());
    return report;
}

}  // namespace macula::study
