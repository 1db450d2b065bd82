#include "study/open/patient_choice.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string>
#include <vector>

namespace macula::study {

namespace {

constexpr std::size_t kMostOfPatient = 6;  // listed series; macula info lists all
constexpr std::size_t kMostPatients = 8;

// "3 (CT, 120 images)". No text of the file that a person may have typed.
Text describe(std::size_t place, const dicom::Series& series) {
    const std::string& modality = series.modality;
    const bool isCode = !modality.empty() && modality.size() <= 16 &&
                        std::ranges::all_of(modality, [](unsigned char c) { return std::isalnum(c) != 0; });
    const Text images = series.instances == 1 ? Text("1 image") : Text("{} images", series.instances);
    return isCode ? Text("{} ({}, {})", place, modality, images) : Text("{} ({})", place, images);
}

Text listOf(std::vector<Text> parts, std::size_t most, std::string_view separator) {
    const std::size_t more = parts.size() - std::min(parts.size(), most);
    parts.resize(parts.size() - more);
    if (more > 0) parts.push_back(Text("{} more", more));
    return Text::joined(std::move(parts), separator);
}

}  // namespace

std::optional<Error> whichPatient(const FoundVolumes& found, const std::filesystem::path& folder) {
    std::map<int, std::vector<Text>> series;  // with volumes, by patient
    std::size_t place = 0;
    for (const dicom::Study& study : found.scan().studies) {
        for (const dicom::Series& each : study.series) {
            ++place;
            const bool hasVolume = std::ranges::any_of(
                each.stacks, [](const dicom::Stack& stack) { return stack.canBeVolume(); });
            if (hasVolume) series[study.patient].push_back(describe(place, each));
        }
    }
    if (series.size() < 2) return std::nullopt;
    std::vector<Text> patients;
    for (const auto& [patient, ofPatient] : series)
        patients.push_back(
            Text("patient {} has series {}", patient + 1, listOf(ofPatient, kMostOfPatient, ", ")));
    return Error{
        ErrorCode::inputNotUsable,
        Text("This folder is of {}, and nothing says which is meant: {}.", dicom::patientsText(found.scan()),
             listOf(patients, kMostPatients, "; ")),
        folder.string(),
        Text("Ask who knows the patient, and open one of the series by its Series Instance UID or by that "
             "number (series_uid).")};
}

}  // namespace macula::study
