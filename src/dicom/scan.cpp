#include "dicom/scan.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/log.h"
#include "base/parallel.h"
#include "dicom/copies.h"
#include "dicom/folder.h"
#include "dicom/patient.h"

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
    std::string studyInstanceUid, date, studyDescription, patientName;
    PatientIdentity patient;
    std::string seriesInstanceUid, modality, description, patientPosition;
    std::optional<int> seriesNumber;
};

// What uncompressed pixel data of this image take at least (one frame: several are no volume anyway); 0 when
// the file does not say.
std::uint64_t pixelBytesNeeded(const Instance& instance, const Dataset& header) {
    const int bits = header.integer(tag::kBitsAllocated).value_or(0);
    if (instance.rows <= 0 || instance.columns <= 0 || bits <= 0 || bits > 64) return 0;
    // Two pixels share their chroma samples: PS3.3 C.7.6.3.1.2.
    const bool halfChroma = instance.photometricInterpretation.ends_with("_422");
    const int samples = halfChroma ? 2 : std::clamp(instance.samplesPerPixel, 1, 4);
    const auto values = static_cast<std::uint64_t>(instance.rows) *
                        static_cast<std::uint64_t>(instance.columns) * static_cast<std::uint64_t>(samples);
    return values * static_cast<std::uint64_t>(bits) / 8;
}

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
    finding.instance.strayBytes = read.strayBytes;
    if (finding.kind == Finding::Kind::image && finding.state == FileState::complete &&
        read.nativePixelBytes && *read.nativePixelBytes < pixelBytesNeeded(finding.instance, header)) {
        finding.state = FileState::truncated;
    }
    finding.studyInstanceUid = text(tag::kStudyInstanceUid);
    finding.date = text(tag::kStudyDate);
    finding.studyDescription = text(tag::kStudyDescription);
    finding.patientName = text(tag::kPatientName);
    finding.patient = patientIdentity(header);
    finding.description = text(tag::kSeriesDescription);
    finding.patientPosition = text(tag::kPatientPosition);
    finding.seriesNumber = header.integer(tag::kSeriesNumber);
    return finding;
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

// Every series of a scan that did not see everything may miss slices, and nothing in it would show that.
void reportFolders(Series& series, std::size_t unreadable) {
    if (unreadable == 0) return;
    const std::string sentence = fmt::format(
        "{} could not be read; slices of this series may be missing.",
        unreadable == 1 ? std::string("A sub-folder") : fmt::format("{} sub-folders", unreadable));
    series.messages.push_back({Severity::warning, std::string(key::kUnreadableFolder), sentence,
                               "Check the permissions of the folders, or copy the study again."});
    series.assumptions.push_back(sentence);
}

struct StudyInProgress {
    Study study;
    std::map<std::pair<std::string, std::string>, Series> series;  // by UID, and by folder if it has none
};

// By patient too: two patients are never mixed into one volume, whatever their UIDs say. A series without UID
// is held together by its folder.
using Studies = std::map<std::pair<std::string, PatientIdentity>, StudyInProgress>;  // by UID and patient

void addImage(Studies& studies, const fs::path& file, Finding& finding) {
    auto& [study, seriesOfStudy] = studies[{finding.studyInstanceUid, finding.patient}];
    if (seriesOfStudy.empty()) {
        study = {.studyInstanceUid = finding.studyInstanceUid,
                 .date = finding.date,
                 .description = finding.studyDescription,
                 .patientName = finding.patientName,
                 .patientId = finding.patient.id,
                 .series = {},
                 .patientBirthDate = finding.patient.birthDate,
                 .patientSex = finding.patient.sex};
    }
    const std::string folder = finding.seriesInstanceUid.empty() ? file.parent_path().string() : "";
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

// A series that was split because its images name several patients looks whole in each part.
void reportSplitSeries(Studies& studies) {
    std::map<std::string, std::vector<Series*>> byUid;
    for (auto& [studyKey, entry] : studies) {
        for (auto& [seriesKey, series] : entry.series) {
            if (!series.seriesInstanceUid.empty()) byUid[series.seriesInstanceUid].push_back(&series);
        }
    }
    for (const auto& [uid, parts] : byUid) {
        if (parts.size() < 2) continue;
        const std::string sentence = fmt::format(
            "The files of this series name different patients or studies, and were split into {} series.",
            parts.size());
        for (Series* series : parts) {
            series->messages.push_back({Severity::warning, std::string(key::kSeveralPatients), sentence,
                                        "Check name, ID, birth date and sex of the patient in every part; "
                                        "slices of this patient may lie in another part."});
            series->assumptions.push_back(sentence);
        }
    }
}

// Incomplete when cancelled.
void group(Scan& scan, const std::vector<fs::path>& files, std::vector<Finding>& findings,
           Progress& progress) {
    Studies studies;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (progress.cancelled()) return;
        if (sortOut(scan, files[i], findings[i])) addImage(studies, files[i], findings[i]);
    }
    reportSplitSeries(studies);
    std::vector<Series*> all;
    std::map<PatientIdentity, int> patients;
    for (auto& [studyKey, entry] : studies) {
        entry.study.patient = patients.emplace(studyKey.second, patients.size()).first->second;
        for (auto& [seriesKey, series] : entry.series) all.push_back(&series);
    }
    scan.patients = static_cast<int>(patients.size());
    dropCopies(all, progress);
    const auto unreadable = static_cast<std::size_t>(
        std::count_if(scan.skipped.begin(), scan.skipped.end(),
                      [](const SkippedFile& s) { return s.message.key == key::kUnreadableFolder; }));
    for (auto& [studyKey, entry] : studies) {
        for (auto& [seriesKey, series] : entry.series) {
            if (progress.cancelled()) return;
            reportDamage(series, scan.skipped);
            reportFolders(series, unreadable);
            assess(series);
            entry.study.series.push_back(std::move(series));
        }
        std::stable_sort(
            entry.study.series.begin(), entry.study.series.end(),
            [](const Series& a, const Series& b) { return a.number.value_or(0) < b.number.value_or(0); });
        scan.studies.push_back(std::move(entry.study));
    }
    std::stable_sort(scan.studies.begin(), scan.studies.end(),
                     [](const Study& a, const Study& b) { return a.date < b.date; });
}

}  // namespace

Result<Scan> scanFolder(const fs::path& path, Progress& progress) try {
    progress.beginStage("Looking for files", 1);
    MACULA_TRY(const FolderListing listing, listFiles(path, progress));
    const std::vector<fs::path>& files = listing.files;
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
    for (const fs::path& folder : listing.unreadable) {
        scan.skipped.push_back(
            {folder,
             {Severity::warning, std::string(key::kUnreadableFolder),
              "A folder cannot be read, and all that is in it is left out.", "Check its permissions."},
             {}});
    }
    group(scan, files, findings, progress);
    if (progress.cancelled()) return cancelledError();
    if (scan.studies.empty() && scan.others.empty()) {
        if (scan.skipped.size() == 1 && files.size() == 1) {
            const SkippedFile& file = scan.skipped.front();
            return Error{ErrorCode::inputNotUsable, file.message.sentence, file.file.string(),
                         file.message.action};
        }
        if (scan.skipped.size() > listing.unreadable.size()) {
            return Error{ErrorCode::inputNotUsable,
                         fmt::format("None of the {} DICOM files in this folder can be read.",
                                     scan.skipped.size() - listing.unreadable.size()),
                         path.string(), "Copy the study again from its source."};
        }
        if (!listing.unreadable.empty()) {
            return Error{ErrorCode::inputNotUsable,
                         "There is no DICOM image in the folder, and some of its sub-folders cannot be read.",
                         path.string(), "Check the permissions of the sub-folders."};
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

std::vector<const Series*> findAllSeries(const Scan& scan, std::string_view seriesInstanceUid) {
    std::vector<const Series*> found;
    for (const Study& study : scan.studies) {
        for (const Series& series : study.series) {
            if (series.seriesInstanceUid == seriesInstanceUid) found.push_back(&series);
        }
    }
    return found;
}

const Series* findSeries(const Scan& scan, std::string_view seriesInstanceUid) {
    const auto found = findAllSeries(scan, seriesInstanceUid);
    return found.size() == 1 ? found.front() : nullptr;
}

}  // namespace macula::dicom
