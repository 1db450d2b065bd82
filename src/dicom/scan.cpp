#include "dicom/scan.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/atomic_file.h"
#include "base/log.h"
#include "base/parallel.h"
#include "base/sha256.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMediaDirectory = "1.2.840.10008.1.3.10";        // DICOMDIR
constexpr std::string_view kSegmentation = "1.2.840.10008.5.1.4.1.1.66.4";  // has pixels, and is no image

Error cancelledError() {
    return {ErrorCode::cancelled, "Reading was cancelled.", {}, {}};
}

// What one file turned out to be, with all that grouping needs, so that headers are dropped as soon as they
// are read.
struct Finding {
    FileState state = FileState::notDicom;
    enum class Kind { image, imageWithoutPixels, other, directory } kind = Kind::other;
    Instance instance;
    std::string studyInstanceUid, date, studyDescription, patientName, patientId;
    std::string seriesInstanceUid, modality, description, patientPosition;
    std::optional<int> seriesNumber;
};

Finding examine(const fs::path& file) {
    Finding finding;
    HeaderFile read = readHeader(file);
    finding.state = read.state;
    if (!read.header) return finding;
    const Dataset& header = *read.header;
    const auto text = [&](Tag tag) { return header.text(tag).value_or(""); };
    finding.modality = text(tag::kModality);
    finding.seriesInstanceUid = text(tag::kSeriesInstanceUid);
    const std::string sopClass = text(tag::kSopClassUid);
    const bool hasImage = header.has(tag::kRows) && header.has(tag::kColumns) && sopClass != kSegmentation;
    if (sopClass == kMediaDirectory) {
        finding.kind = Finding::Kind::directory;
        return finding;
    }
    if (!hasImage) {
        finding.kind = Finding::Kind::other;
        finding.instance.sopClassUid = sopClass;
        return finding;
    }
    finding.kind = header.has(tag::kPixelData) ? Finding::Kind::image : Finding::Kind::imageWithoutPixels;
    finding.instance = readInstance(file, header);
    finding.studyInstanceUid = text(tag::kStudyInstanceUid);
    finding.date = text(tag::kStudyDate);
    finding.studyDescription = text(tag::kStudyDescription);
    finding.patientName = text(tag::kPatientName);
    finding.patientId = text(tag::kPatientId);
    finding.description = text(tag::kSeriesDescription);
    finding.patientPosition = text(tag::kPatientPosition);
    finding.seriesNumber = header.integer(tag::kSeriesNumber);
    return finding;
}

Result<std::vector<fs::path>> listFiles(const fs::path& path, Progress& progress) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        return Error{ErrorCode::inputNotUsable, "The folder does not exist.", path.string(),
                     "Check the path."};
    }
    if (fs::is_regular_file(status)) return std::vector<fs::path>{path};
    fs::recursive_directory_iterator at(path, fs::directory_options::skip_permission_denied, error);
    if (!fs::is_directory(status) || error) {
        return Error{ErrorCode::inputNotUsable, "The folder cannot be read.", path.string(),
                     "Check that it is a folder, and its permissions."};
    }
    std::vector<fs::path> files;
    while (at != fs::recursive_directory_iterator()) {
        if (progress.cancelled()) return cancelledError();
        std::error_code ignored;  // a file that vanished meanwhile is not listed
        if (at->is_regular_file(ignored)) files.push_back(at->path());
        at.increment(error);
        if (error) {
            log::warning("a folder could not be listed to its end: {}", error.message());
            break;
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

void skip(Scan& scan, const fs::path& file, const Finding& finding, std::string_view key,
          std::string sentence, std::string action) {
    log::info("skipped {}: {}", log::Sensitive{file.native()}, key);
    scan.skipped.push_back({file,
                            {Severity::warning, std::string(key), std::move(sentence), std::move(action)},
                            finding.seriesInstanceUid});
}

// True when the file is to be grouped as an image.
bool sortOut(Scan& scan, const fs::path& file, const Finding& finding) {
    const std::string copyAgain = "Copy the file again from its source.";
    switch (finding.state) {
        case FileState::notDicom:
            ++scan.notDicom;
            return false;
        case FileState::unreadable:
            skip(scan, file, finding, key::kUnreadableFile, "A file cannot be opened.",
                 "Check its permissions.");
            return false;
        case FileState::damaged:
            skip(scan, file, finding, key::kDamagedFile, "A DICOM file is damaged and cannot be read.",
                 copyAgain);
            return false;
        case FileState::truncated:
            skip(scan, file, finding, key::kTruncatedFile, "A DICOM file ends before its pixel data do.",
                 copyAgain);
            return false;
        case FileState::complete:
            break;
    }
    switch (finding.kind) {
        case Finding::Kind::directory:
            return false;
        case Finding::Kind::other:
            scan.others.push_back({file, finding.modality, finding.instance.sopClassUid});
            return false;
        case Finding::Kind::imageWithoutPixels:
            skip(scan, file, finding, key::kNoPixelData, "A DICOM image has no pixel data.", copyAgain);
            return false;
        case Finding::Kind::image:
            break;
    }
    return true;
}

bool sameContent(const fs::path& a, const fs::path& b) {
    constexpr std::size_t kLargest = std::size_t{1} << 31;
    std::error_code error;
    if (fs::file_size(a, error) != fs::file_size(b, error) || error) return false;
    const auto bytesA = readText(a, kLargest);
    const auto bytesB = readText(b, kLargest);
    return bytesA && bytesB && *bytesA == *bytesB;
}

// The same file twice (a folder copied into itself) is no second slice. Files that share a SOP Instance UID
// and differ are kept: which of them is right is not ours to say, and their equal positions will be reported.
void dropCopies(Series& series) {
    std::map<std::string, std::vector<fs::path>> kept;
    std::vector<Instance> unique;
    for (Instance& instance : series.instances) {
        if (!instance.sopInstanceUid.empty()) {
            std::vector<fs::path>& twins = kept[instance.sopInstanceUid];
            if (std::any_of(twins.begin(), twins.end(),
                            [&](const fs::path& twin) { return sameContent(twin, instance.file); })) {
                continue;
            }
            twins.push_back(instance.file);
        }
        unique.push_back(std::move(instance));
    }
    if (const std::size_t dropped = series.instances.size() - unique.size(); dropped > 0) {
        series.messages.push_back({Severity::info, std::string(key::kDuplicateFiles),
                                   fmt::format("{} {} of a file that is there already, and left out.",
                                               dropped, dropped == 1 ? "file is a copy" : "files are copies"),
                                   "Nothing to do."});
    }
    series.instances = std::move(unique);
}

// Files that belong to a series, and are missing from it, must be told of where the series is shown.
void reportDamage(Series& series, const std::vector<SkippedFile>& skipped) {
    if (series.seriesInstanceUid.empty()) return;
    const auto count = std::count_if(skipped.begin(), skipped.end(), [&](const SkippedFile& s) {
        return s.seriesInstanceUid == series.seriesInstanceUid;
    });
    if (count == 0) return;
    series.messages.push_back(
        {Severity::warning, std::string(key::kTruncatedFile),
         fmt::format("{} of this series cannot be read, and {} left out.",
                     count == 1 ? std::string("One file") : fmt::format("{} files", count),
                     count == 1 ? "is" : "are"),
         "Copy the series again from its source."});
}

void group(Scan& scan, const std::vector<fs::path>& files, std::vector<Finding>& findings) {
    // By patient too: two patients are never mixed into one volume, whatever their UIDs say. A series without
    // UID is held together by its folder.
    using StudyKey = std::pair<std::string, std::string>;   // UID, patient ID
    using SeriesKey = std::pair<std::string, std::string>;  // UID, folder
    std::map<StudyKey, std::pair<Study, std::map<SeriesKey, Series>>> studies;
    for (std::size_t i = 0; i < files.size(); ++i) {
        Finding& finding = findings[i];
        if (!sortOut(scan, files[i], finding)) continue;
        auto& [study, seriesOfStudy] = studies[{finding.studyInstanceUid, finding.patientId}];
        if (seriesOfStudy.empty()) {
            study = {finding.studyInstanceUid, finding.date,      finding.studyDescription,
                     finding.patientName,      finding.patientId, {}};
        }
        const std::string folder = finding.seriesInstanceUid.empty() ? files[i].parent_path().string() : "";
        Series& series = seriesOfStudy[{finding.seriesInstanceUid, folder}];
        if (series.instances.empty()) {
            series.studyInstanceUid = finding.studyInstanceUid;
            series.seriesInstanceUid = finding.seriesInstanceUid;
            series.modality = finding.modality;
            series.description = finding.description;
            series.number = finding.seriesNumber;
            series.patientPosition = finding.patientPosition;
        }
        series.instances.push_back(std::move(finding.instance));
    }
    for (auto& [studyKey, entry] : studies) {
        for (auto& [seriesKey, series] : entry.second) {
            dropCopies(series);
            reportDamage(series, scan.skipped);
            assess(series);
            entry.first.series.push_back(std::move(series));
        }
        std::stable_sort(
            entry.first.series.begin(), entry.first.series.end(),
            [](const Series& a, const Series& b) { return a.number.value_or(0) < b.number.value_or(0); });
        scan.studies.push_back(std::move(entry.first));
    }
    std::stable_sort(scan.studies.begin(), scan.studies.end(),
                     [](const Study& a, const Study& b) { return a.date < b.date; });
}

}  // namespace

Result<Scan> scanFolder(const fs::path& path, Progress& progress) try {
    progress.beginStage("Looking for files", 1);
    MACULA_TRY(const std::vector<fs::path> files, listFiles(path, progress));
    progress.beginStage(fmt::format("Reading {} files", files.size()), files.size());
    std::vector<Finding> findings(files.size());
    parallelFor(
        files.size(),
        [&](std::size_t i) {
            try {
                findings[i] = examine(files[i]);
            } catch (...) {
                findings[i].state = FileState::damaged;
            }
            progress.advance();
        },
        progress.token());
    if (progress.cancelled()) return cancelledError();

    Scan scan;
    scan.filesSeen = files.size();
    group(scan, files, findings);
    if (scan.studies.empty() && scan.others.empty()) {
        if (scan.skipped.size() == 1 && files.size() == 1) {
            const SkippedFile& file = scan.skipped.front();
            return Error{ErrorCode::inputNotUsable, file.message.sentence, file.file.string(),
                         file.message.action};
        }
        if (!scan.skipped.empty()) {
            return Error{
                ErrorCode::inputNotUsable,
                fmt::format("None of the {} DICOM files in this folder can be read.", scan.skipped.size()),
                path.string(), "Copy the study again from its source."};
        }
        return Error{
            ErrorCode::inputNotUsable,
            files.size() == 1
                ? "The file is not a DICOM image."
                : fmt::format("There is no DICOM image among the {} files of this folder.", files.size()),
            path.string(), "Choose a folder with DICOM images."};
    }
    return scan;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "There is not enough memory to read this folder.", path.string(),
                 "Choose a smaller folder."};
} catch (const std::exception&) {
    return Error{ErrorCode::inputNotUsable, "The folder cannot be read.", path.string(),
                 "Check its permissions."};
}

const Series* findSeries(const Scan& scan, std::string_view seriesInstanceUid) {
    for (const Study& study : scan.studies) {
        for (const Series& series : study.series) {
            if (series.seriesInstanceUid == seriesInstanceUid) return &series;
        }
    }
    return nullptr;
}

}  // namespace macula::dicom
