#include "cli/study_input.h"

#include <algorithm>
#include <charconv>

#include "base/phantom.h"
#include "base/sha256.h"
#include "dicom/loader.h"
#include "dicom/scan.h"

namespace macula::cli {

namespace {

const dicom::Series* atPlace(const dicom::Scan& scan, std::size_t place) {
    for (const dicom::Study& study : scan.studies) {
        if (place <= study.series.size()) return place == 0 ? nullptr : &study.series[place - 1];
        place -= study.series.size();
    }
    return nullptr;
}

Result<const dicom::Series*> chooseSeries(const dicom::Scan& scan, const std::string& wanted,
                                          std::string& why) {
    if (wanted.empty()) {
        if (const dicom::Series* best = dicom::bestSeries(scan, &why)) return best;
        return Error{ErrorCode::inputNotUsable,
                     why,
                     {},
                     "Choose another folder; macula info tells more about this one."};
    }
    const dicom::Series* chosen = dicom::findSeries(scan, wanted);
    std::size_t place = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), place);
    if (!chosen && error == std::errc() && end == wanted.data() + wanted.size())
        chosen = atPlace(scan, place);
    if (chosen) return chosen;
    if (dicom::findAllSeries(scan, wanted).size() > 1) {
        return Error{ErrorCode::usage, "Several patients have a series of this UID.", wanted,
                     "Choose by the number in front of it in macula info."};
    }
    return Error{ErrorCode::usage, "There is no such series in the folder.", wanted,
                 "See macula info for the list; --series takes the number in front, or the series UID."};
}

}  // namespace

Result<StudyInput> loadStudy(const std::filesystem::path& path, const std::string& series,
                             Progress& progress) {
    StudyInput input;
    if (path.empty() || path == "phantom:") {
        if (!series.empty()) {
            return Error{
                ErrorCode::usage, "The phantom has no series to choose from.", {}, "Leave --series out."};
        }
        if (path.empty()) input.notes.emplace_back("No folder was given: this is the built-in phantom.");
        input.volume = std::make_shared<const Volume>(phantom::make());
        input.seriesDigest = "phantom";
        return input;
    }

    MACULA_TRY(const dicom::Scan scan, dicom::scanFolder(path, progress));
    std::string why;
    auto chosen = chooseSeries(scan, series, why);
    if (!chosen) {
        Error error = chosen.error();
        if (error.where.empty()) error.where = path.string();
        return error;
    }
    std::size_t seriesCount = 0;
    for (const dicom::Study& study : scan.studies) seriesCount += study.series.size();
    if (seriesCount > 1 && !why.empty()) input.notes.push_back(why);
    if (!scan.skipped.empty()) {
        input.notes.push_back(
            fmt::format("{} files were left out; macula info says why.", scan.skipped.size()));
    }
    for (const dicom::Message& message : (*chosen)->messages) {
        if (message.severity == dicom::Severity::warning) {
            input.notes.push_back(message.sentence + (message.action.empty() ? "" : " " + message.action));
        }
    }
    MACULA_TRY(input.volume, dicom::loadVolume(**chosen, progress));
    for (const std::string& assumption : input.volume->provenance().assumptions)
        input.notes.push_back(assumption);
    input.seriesDigest = sha256Hex((*chosen)->seriesInstanceUid);
    return input;
}

void bringTo16Bits(StudyInput& study) {
    const std::size_t known = study.volume->provenance().assumptions.size();
    study.volume = in16Bits(std::move(study.volume));
    const std::vector<std::string>& assumptions = study.volume->provenance().assumptions;
    study.notes.insert(study.notes.end(), assumptions.begin() + static_cast<std::ptrdiff_t>(known),
                       assumptions.end());
}

}  // namespace macula::cli
