#include "dicom/scan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <utility>

#include "base/check.h"
#include "base/exceptions.h"
#include "base/log.h"
#include "base/parallel.h"
#include "dicom/read/dictionary.h"
#include "dicom/read/folder.h"
#include "dicom/read/placeholder.h"
#include "dicom/scan_failure.h"
#include "dicom/scan_glimpse.h"
#include "dicom/split/copies.h"
#include "dicom/split/join.h"
#include "dicom/split/missing_images.h"
#include "dicom/split/other_series.h"
#include "dicom/split/split.h"
#include "dicom/stack/examination.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

Error cancelledError() {
    return {ErrorCode::cancelled, Text("Reading was cancelled."), {}, {}};
}

TextArgument count(std::size_t value) {
    return {"count", static_cast<std::int64_t>(value)};
}

struct SeriesInProgress {
    Series series;
    std::vector<Frame> frames;
    std::map<std::string_view, std::size_t> leftOut;  // files that belong here and cannot be used, by reason
    std::size_t framesMissing = 0;
    std::size_t framesClaimed = 0;  // frames claimed by the files that lack some
    std::size_t withoutSopClass = 0;
    bool charsetFallback = false;
};

struct StudyInProgress {
    Study study;
    std::map<std::pair<std::string, std::string>, SeriesInProgress>
        series;  // by UID, by folder if it has none
};

// Studies are keyed by patient too: two patients are never mixed into one volume, whatever their UIDs say. A
// series without UID is held together by its folder.
using Studies = std::map<std::pair<std::string, PatientIdentity>, StudyInProgress>;  // by UID and patient

// The reason why the file cannot be used, if there is one.
std::optional<std::string_view> reasonToSkip(const Examination& found) {
    switch (found.state) {
        case FileState::unreadable:
            return key::kUnreadableFile;
        case FileState::offline:
            return key::kFileOffline;
        case FileState::mediumError:
            return key::kUnreadableMedium;
        case FileState::pathTooLong:
            return key::kPathTooLong;
        case FileState::damaged:
            return key::kDamagedFile;
        case FileState::truncated:
            return key::kTruncatedFile;
        case FileState::notDicom:
        case FileState::complete:
            break;
    }
    if (found.kind == Examination::Kind::imageWithoutPixels) return key::kNoPixelData;
    if (found.invalidFrameCount) return key::kInvalidFrameCount;
    return {};
}

SeriesInProgress& placeOf(Studies& studies, const fs::path& file, const Examination& found) {
    auto& [study, seriesOfStudy] = studies[{found.studyInstanceUid, found.patient}];
    if (seriesOfStudy.empty()) {
        study = {.studyInstanceUid = found.studyInstanceUid,
                 .date = found.studyDate,
                 .description = found.studyDescription,
                 .patientName = found.patientName,
                 .patientId = found.patient.id,
                 .series = {},
                 .patientBirthDate = found.patient.birthDate,
                 .patientSex = found.patient.sex};
    }
    const std::string folder = found.seriesInstanceUid.empty() ? file.parent_path().string() : "";
    const auto [place, isNew] = seriesOfStudy.try_emplace({found.seriesInstanceUid, folder});
    Series& series = place->second.series;
    if (isNew) {
        series.studyInstanceUid = found.studyInstanceUid;
        series.seriesInstanceUid = found.seriesInstanceUid;
        series.modality = found.modality;
        series.description = found.seriesDescription;
        series.number = found.seriesNumber;
        series.patientPosition = found.patientPosition;
    }
    return place->second;
}

// The DICOMDIR of a disc only shows which files are missing; files on the disc are read whether listed or
// not.
void report(Scan& scan, const ListedFiles& listed) {
    for (std::size_t i = 0; i < listed.unreadable; ++i)
        scan.messages.push_back(message(key::kDicomdirUnreadable));
    scan.listedFilesMissing = listed.missing;
    if (listed.missing > 0)
        scan.messages.push_back(message(key::kDicomdirMissingFiles, {count(listed.missing)}));
    if (listed.outside > 0) scan.messages.push_back(message(key::kDicomdirOutside, {count(listed.outside)}));
}

void sortIn(Scan& scan, Studies& studies, const fs::path& file, Examination& found) {
    const auto reason = reasonToSkip(found);
    if (reason) {
        log::info("skipped {}: {}", log::Sensitive{file.native()}, *reason);
        scan.skipped.push_back({file, message(*reason), found.seriesInstanceUid});
        // A file without a header cannot be assigned to a series.
        if (!found.studyInstanceUid.empty() || !found.seriesInstanceUid.empty()) {
            ++placeOf(studies, file, found).leftOut[*reason];
        }
        return;
    }
    if (found.state == FileState::notDicom) {
        ++scan.notDicom;
        if (!found.archive.empty()) {
            ++scan.archives;
            scan.archiveKinds.insert(found.archive);
        }
        return;
    }
    if (found.kind == Examination::Kind::directory) return;
    SeriesInProgress& place = placeOf(studies, file, found);
    place.charsetFallback = place.charsetFallback || found.charsetFallback;
    place.series.scattered = place.series.scattered || found.scattered;
    if (found.kind == Examination::Kind::other) {
        place.series.objects.push_back(std::move(found.object));
        return;
    }
    if (found.framesMissing > 0) {
        place.framesMissing += found.framesMissing;
        place.framesClaimed += static_cast<std::size_t>(found.frames.front().instance->framesClaimed);
    }
    place.withoutSopClass += found.frames.front().instance->sopClassUid.empty() ? 1 : 0;
    std::move(found.frames.begin(), found.frames.end(), std::back_inserter(place.frames));
}

// A series that was split because its images name several patients looks whole in each part.
void reportSplitSeries(Studies& studies) {
    std::map<std::string, std::vector<Series*>> byUid;
    for (auto& [studyKey, entry] : studies) {
        for (auto& [seriesKey, place] : entry.series) {
            if (!place.series.seriesInstanceUid.empty()) {
                byUid[place.series.seriesInstanceUid].push_back(&place.series);
            }
        }
    }
    for (const auto& [uid, parts] : byUid) {
        if (parts.size() < 2) continue;
        for (Series* series : parts) tell(*series, message(key::kSeveralPatients, {count(parts.size())}));
    }
}

// Reports images that are stored in several files (PS3.3 C.7.6.16.2.2.4), some of which are missing.
void reportConcatenations(SeriesInProgress& place) {
    std::map<std::string, std::pair<std::set<const Instance*>, int>> concatenations;
    for (const Frame& frame : place.frames) {
        if (frame.instance->concatenationUid.empty()) continue;
        auto& [parts, total] = concatenations[frame.instance->concatenationUid];
        parts.insert(frame.instance.get());
        total = std::max(total, frame.instance->concatenationTotal);
    }
    for (const auto& [uid, entry] : concatenations) {
        const auto there = static_cast<std::int64_t>(entry.first.size());
        if (there >= entry.second) continue;
        tell(place.series, message(key::kIncompleteConcatenation, {{"missing", entry.second - there},
                                                                   {"total", std::int64_t(entry.second)}}));
    }
}

// Reports what is known about the series from its files, before its frames are examined.
void reportFiles(SeriesInProgress& place, std::size_t copies, std::size_t repeats,
                 std::size_t unreadableFolders) {
    Series& series = place.series;
    if (copies > 0) tell(series, message(key::kDuplicateFiles, {count(copies)}));
    if (repeats > 0) tell(series, message(key::kRepeatedImages, {count(repeats)}));
    std::size_t leftOut = 0;
    for (const auto& [reason, files] : place.leftOut) {
        series.messages.push_back(message(reason));
        leftOut += files;
    }
    const bool nothingLeft = place.frames.empty() && series.objects.empty();
    if (leftOut > 0) {
        tell(series, message(nothingLeft ? key::kNoValidInstances : key::kFilesLeftOut, {count(leftOut)}));
    }
    if (place.framesMissing > 0) {
        tell(series, message(key::kMissingFrames, {{"missing", std::int64_t(place.framesMissing)},
                                                   {"total", std::int64_t(place.framesClaimed)}}));
    }
    if (place.withoutSopClass > 0)
        tell(series, message(key::kMissingSopClass, {count(place.withoutSopClass)}));
    if (place.charsetFallback) tell(series, message(key::kCharsetFallback));
    // Every series of a scan that did not see everything may lack slices, and nothing in it would show that.
    if (unreadableFolders > 0) tell(series, message(key::kUnreadableFolder, {count(unreadableFolders)}));
    if (place.frames.empty()) {
        std::map<std::string, Text> kinds;
        std::size_t presentations = 0;
        for (const OtherObject& object : series.objects) {
            if (object.presentation) {
                ++presentations;
            } else {
                kinds.try_emplace(object.kind.english(), object.kind);
            }
        }
        if (presentations > 0) tell(series, message(key::kPresentationState, {count(presentations)}));
        for (const auto& [english, kind] : kinds)
            tell(series, message(key::kUnsupportedSopClass, {{"kind", kind}}));
    }
    reportConcatenations(place);
}

// Makes the series: from frames to stacks.
Series finish(SeriesInProgress& place, const CancelToken& cancel) {
    Series series = std::move(place.series);
    std::set<const Instance*> instances;
    std::set<std::string> syntaxes;
    for (const Frame& frame : place.frames) {
        instances.insert(frame.instance.get());
        syntaxes.insert(frame.instance->transferSyntaxUid);
    }
    series.instances = instances.size();
    for (const auto& [reason, files] : place.leftOut) series.filesLeftOut += files;
    series.transferSyntaxUids.assign(syntaxes.begin(), syntaxes.end());
    Split split = splitSeries(std::move(place.frames), series.modality, splitRules(), cancel);
    series.stacks = std::move(split.stacks);
    // The modality is that of most images, not that of the file that came first.
    const auto largest =
        std::max_element(series.stacks.begin(), series.stacks.end(),
                         [](const Stack& a, const Stack& b) { return a.frames.size() < b.frames.size(); });
    if (largest != series.stacks.end()) series.modality = largest->modality;
    for (Message& message : split.messages) series.messages.push_back(std::move(message));
    return series;
}

// The argument of messages about scattered images, which are made before files are sorted into series.
TextArgument levels(const Scattered& scattered) {
    return {"level", scattered.levels};
}

// Joins each set of scattered images if that was requested, otherwise asks about it.
void askOrJoin(Scan& scan, std::vector<Examination>& found, const std::vector<Scattered>& all,
               const ScanOptions& options) {
    for (const Scattered& scattered : all) {
        if (options.join) {
            join(found, scattered);
            continue;
        }
        scan.messages.push_back(
            message(key::kUidPerSlice, {count(scattered.images.size()), levels(scattered)}));
        for (const std::size_t i : scattered.images) found[i].scattered = true;
    }
}

// The files that the DICOMDIRs among `files` list, compared with those found.
ListedFiles listedFiles(const std::vector<fs::path>& files, const std::vector<Examination>& found) {
    std::vector<fs::path> directories;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (found[i].state == FileState::complete && found[i].kind == Examination::Kind::directory)
            directories.push_back(files[i]);
    }
    return compareWithDirectories(directories, found);
}

// Compares the series of a study, and reports how they continue each other and what is missing.
void compareSeries(Scan& scan, std::vector<Series>& series, const AbsentImages& absent) {
    reportNeighbours(series);
    reportMissingImages(series, absent);
    reportFartherReach(series);
    if (auto shortfall = studyShortfall(series)) scan.messages.push_back(std::move(*shortfall));
}

// Groups files into studies and series. Incomplete when cancelled.
void group(Scan& scan, const std::vector<fs::path>& files, std::vector<Examination>& found,
           const ScanOptions& options, Progress& progress) {
    Studies studies;
    const ListedFiles listed = listedFiles(files, found);
    report(scan, listed);
    const std::vector<Scattered> scattered = findScattered(found);
    askOrJoin(scan, found, scattered, options);
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (progress.cancelled()) return;
        sortIn(scan, studies, files[i], found[i]);
    }
    for (const Scattered& joined : scattered) {
        if (!options.join) break;
        const std::size_t first = joined.images.front();
        tell(placeOf(studies, files[first], found[first]).series,
             message(key::kJoined, {count(joined.images.size()), levels(joined)}));
    }
    reportSplitSeries(studies);
    std::vector<SeriesInProgress*> places;
    std::vector<std::vector<Frame>*> frames;
    PatientNumbers patients;
    for (auto& [studyKey, entry] : studies) {
        entry.study.patient = patients.of(studyKey.second, studyKey.first);
        for (auto& [seriesKey, place] : entry.series) {
            places.push_back(&place);
            frames.push_back(&place.frames);
        }
    }
    scan.patients = patients.count();
    scan.namelessPatients = patients.nameless();
    const std::vector<std::size_t> copies = dropCopies(frames, progress);
    const std::vector<std::size_t> repeats = dropRepeats(frames, progress.token());
    std::vector<Series> finished(places.size());
    parallelFor(
        places.size(),
        [&](std::size_t i) {
            reportFiles(*places[i], copies[i], repeats[i], scan.unreadableFolders);
            finished[i] = finish(*places[i], progress.token());
        },
        progress.token());
    if (progress.cancelled()) return;
    std::size_t next = 0;
    for (auto& [studyKey, entry] : studies) {
        for (std::size_t i = 0; i < entry.series.size(); ++i) {
            entry.study.series.push_back(std::move(finished[next++]));
        }
        std::stable_sort(
            entry.study.series.begin(), entry.study.series.end(),
            [](const Series& a, const Series& b) { return a.number.value_or(0) < b.number.value_or(0); });
        compareSeries(scan, entry.study.series, listed.absent);
        scan.studies.push_back(std::move(entry.study));
    }
    std::stable_sort(scan.studies.begin(), scan.studies.end(),
                     [](const Study& a, const Study& b) { return a.date < b.date; });
}

Message messageOf(const UnreadableFolder& folder) {
    switch (stateOfFailure(folder.error)) {
        case FileState::mediumError:
            return message(key::kUnreadableMedium);
        case FileState::pathTooLong:
            return message(key::kPathTooLong);
        default:
            return message(key::kUnreadableFolder, {count(1)});
    }
}

// Whether the path is a DICOMDIR, which people click on to open a disc.
bool isMediaDirectoryName(const fs::path& path) {
    std::string name = path.filename().string();
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    std::error_code error;
    return name.starts_with("DICOMDIR") && fs::is_regular_file(path, error);
}

}  // namespace

std::size_t Scan::imageCount() const {
    std::size_t count = 0;
    for (const Study& study : studies) {
        for (const Series& series : study.series) count += series.instances;
    }
    return count;
}

std::size_t Scan::objectCount() const {
    std::size_t count = 0;
    for (const Study& study : studies) {
        for (const Series& series : study.series) count += series.objects.size();
    }
    return count;
}

Result<Scan> scanFolder(const fs::path& path, Progress& progress, const ScanOptions& options) try {
    if (!hasDictionary()) {
        return Error{
            ErrorCode::inputNotUsable,
            Text("The dictionary of the DICOM toolkit (dicom.dic) is not there, so that DICOM files cannot "
                 "be read."),
            {},
            Text("Install DCMTK's data files again, or set DCMDICTPATH to the path of dicom.dic.")};
    }
    progress.beginStage(Text("Looking for files"), 1);
    const bool isDirectory =
        isMediaDirectoryName(path) && examine(path, progress.token()).kind == Examination::Kind::directory;
    MACULA_TRY(const FolderListing listing,
               listFiles(isDirectory ? fs::absolute(path).parent_path() : path, progress));
    const std::vector<fs::path>& files = listing.files;
    progress.beginStage(files.size() == 1 ? Text("Reading 1 file") : Text("Reading {} files", files.size()),
                        files.size());
    std::vector<Examination> found(files.size());
    std::atomic<bool> noMemory{false};
    ScanGlimpses glimpses(options.glimpsed);
    parallelFor(
        files.size(),
        [&](std::size_t i) {
            try {
                if (!noMemory) found[i] = examine(files[i], progress.token());
                if (!progress.cancelled()) glimpses.add(found[i]);
            } catch (const std::bad_alloc&) {
                noMemory = true;  // which does not mean that a file is damaged
            } catch (const CheckFailure&) {
                throw;  // a bug in Macula, not a fault of the file
            } catch (...) {
                found[i].state = FileState::damaged;
            }
            progress.advance();
        },
        progress.token());
    if (noMemory) throw std::bad_alloc();
    if (progress.cancelled()) return cancelledError();

    Scan scan;
    scan.filesSeen = files.size();
    scan.unreadableFolders = listing.unreadable.size();
    if (listing.linksOutside > 0)
        scan.messages.push_back(message(key::kLinksOutside, {count(listing.linksOutside)}));
    for (const UnreadableFolder& folder : listing.unreadable)
        scan.skipped.push_back({folder.path, messageOf(folder), {}, true});
    group(scan, files, found, options, progress);
    if (progress.cancelled()) return cancelledError();
    if (scan.archives > 0) {
        const std::string kinds = fmt::format("{}", fmt::join(scan.archiveKinds, ", "));
        scan.messages.push_back(message(key::kArchives, {count(scan.archives), {"kinds", kinds}}));
    }
    if (scan.imageCount() == 0 && scan.objectCount() == 0) return nothingFound(scan, path, listing);
    return scan;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read this folder"), path.string());
}

Text patientsText(const Scan& scan) {
    if (scan.patients == 1) return Text("1 patient");
    return scan.namelessPatients > 1 ? Text("up to {} patients", scan.patients)
                                     : Text("{} patients", scan.patients);
}

bool mayBeOnePatient(const Scan& scan, int patient, int other) {
    if (patient == other) return true;
    const auto isNameless = [&](int number) {
        const auto study = std::ranges::find(scan.studies, number, &Study::patient);
        return study != scan.studies.end() && isPlaceholder(study->patientId) &&
               isPlaceholder(study->patientName);
    };
    return isNameless(patient) && isNameless(other);
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
