#include "study/open/opened_study.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "base/exceptions.h"
#include "base/fingerprint.h"
#include "base/phantom.h"
#include "base/quantised.h"
#include "base/sha256.h"
#include "dicom/loader.h"
#include "dicom/messages/messages.h"
#include "dicom/read/media_directory.h"
#include "formats/volume_file.h"
#include "study/open/found_volumes.h"
#include "study/open/image_numbers.h"
#include "study/open/scanned_place.h"
#include "study/open/volumes_of_file.h"
#include "unpack/archive_name.h"

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

// The error for a folder with several patients where the caller named no series: inputNotUsable with a list,
// the series of each patient, by their numbers in `macula info`, which
// FoundVolumes::ofSeries takes. It numbers patients and names none. Nothing if all volumes belong to one
// patient.
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

constexpr std::string_view kPet = "PT";

Result<OpenedStudy> openPhantom(Progress& progress) {
    progress.beginStage(Text("Making the phantom"), 1);
    auto volume = std::make_shared<const Volume>(phantom::make());
    if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Loading was cancelled."), {}, {}};
    progress.advance();
    return OpenedStudy{.volume = std::move(volume),
                       .seriesDigest = "phantom",
                       .identity = {.series = Text("Built-in phantom"), .isOfNobody = true},
                       .description = Text("Built-in phantom")};
}

OpenedStudy studyOf(std::shared_ptr<const Volume> volume, const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    std::string digest = fingerprint(*volume);
    Quantised drawn = quantised(volume);
    return OpenedStudy{.volume = std::move(drawn.volume),
                       .inFloats = drawn.isExact ? nullptr : std::move(volume),
                       .seriesDigest = std::move(digest),
                       .identity = {.series = Text("File {}", name)},
                       .description = Text::verbatim(name)};
}

// Opens a NIfTI, NRRD or MetaImage file, which has no patient name, at its first volume.
Result<OpenedStudy> openVolumeFile(const std::filesystem::path& path, Progress& progress) {
    MACULA_TRY(const formats::VolumeFileInfo info, formats::readVolumeFileInfo(path));
    MACULA_TRY(std::shared_ptr<const Volume> volume, formats::readVolumeFile(path, progress));
    OpenedStudy study = studyOf(std::move(volume), path);
    if (info.volumes > kMostVolumesOfFile) {
        study.messages.push_back(
            Text("The file holds {} volumes; Macula can choose from {} at most, and "
                 "shows the first alone.",
                 info.volumes, kMostVolumesOfFile));
    } else if (info.volumes > 1) {
        study.ofFile =
            std::make_shared<const VolumesOfFile>(VolumesOfFile{.file = path,
                                                                .count = info.volumes,
                                                                .axis = info.axis,
                                                                .size = info.size,
                                                                .worldFromVoxel = info.worldFromVoxel});
    }
    return study;
}

Result<OpenedStudy> volumeOfFile(std::shared_ptr<const VolumesOfFile> volumes, std::size_t index,
                                 Progress& progress) {
    MACULA_TRY(std::shared_ptr<const Volume> volume,
               formats::readVolumeFile(volumes->file, progress, index + 1));
    if (volume->size() != volumes->size || volume->worldFromVoxel() != volumes->worldFromVoxel)
        return Error{ErrorCode::inputNotUsable, Text("The file is another one by now."),
                     volumes->file.string(), Text("Open it again.")};
    OpenedStudy study = studyOf(std::move(volume), volumes->file);
    study.volumeIndex = index;
    study.ofFile = std::move(volumes);
    return study;
}

bool isMediaDirectory(const std::filesystem::path& file) {
    return dicom::readMediaDirectory(file).ok();
}

// Returns the question whether images are one series (dicom::key::kUidPerSlice), when the folder holds no
// volume without an answer; otherwise nothing.
Text joinQuestionOf(const FoundVolumes& found) {
    const auto& messages = found.scan().messages;
    const auto asked = std::ranges::find(messages, dicom::key::kUidPerSlice, &Message::key);
    return found.volumes().empty() && asked != messages.end() ? asked->sentence : Text();
}

Result<OpenedStudy> loadFound(std::shared_ptr<const FoundVolumes> found, std::size_t index,
                              Progress& progress) {
    const FoundVolume& chosen = found->volumes().at(index);
    MACULA_TRY(std::shared_ptr<const Volume> volume,
               dicom::loadVolume(*chosen.series, *chosen.stack, progress, {.onCoarse = {}, .inSuv = true}));
    Quantised drawn = quantised(volume);
    OpenedStudy study{.volume = std::move(drawn.volume),
                      .inFloats = drawn.isExact ? nullptr : std::move(volume),
                      .seriesDigest = sha256Hex(chosen.series->seriesInstanceUid),
                      .identity = identityOf(chosen),
                      .description = Text::verbatim(chosen.series->description),
                      .whyThisSeries = Text("The volume that was chosen."),
                      .volumeTitles = found->titles(),
                      .volumeIndex = index};
    study.isLowBright =
        study.volume->modality() == kPet || std::ranges::any_of(chosen.stack->messages, [](const Message& m) {
            return m.key == dicom::key::kInvertedDisplay;
        });
    study.frameOfReferenceUid = frameOfReferenceOf(*chosen.stack);
    study.dose = dicom::doseFactsOf(found->scan(), *chosen.stack);
    study.imageNumbers = imageNumbersOf(*chosen.stack, study.volume->size().z);
    // Skips repetitions: a series and its volume may have the same message.
    const auto tell = [&](const std::vector<Message>& messages) {
        for (const Message& message : messages) {
            if (message.severity == Severity::info) continue;
            const std::string said = message.sentence.english();
            const bool isKnown =
                std::ranges::any_of(study.messages, [&](const Text& known) { return known == said; });
            if (!isKnown) study.messages.push_back(message.sentence);
        }
    };
    const dicom::Scan& scan = found->scan();
    tell(scan.messages);
    tell(chosen.series->messages);
    tell(chosen.stack->messages);
    tell(study.volume->provenance().messages);
    if (!scan.skipped.empty()) {
        study.messages.push_back(
            scan.skipped.size() == 1
                ? Text("1 file was left out; the list of studies and `macula info` on the folder say why.")
                : Text("{} files were left out; the list of studies and `macula info` on the folder say why.",
                       scan.skipped.size()));
    }
    study.found = std::move(found);
    return study;
}

// Leaves the description of the series out, because it may name somebody.
Text notOpened(const FoundVolume& volume, const Text& why) {
    const std::size_t images = volume.stack->frames.size();
    if (const auto number = volume.series->number)
        return Text("Series {} ({} images) could not be opened: {}", *number, images, why);
    return Text("A series without a number ({} images) could not be opened: {}", images, why);
}

// Loads the best volume that can be decoded, with messages on better ones that cannot. If none can be
// decoded, returns the error of the first.
Result<OpenedStudy> loadBest(const std::shared_ptr<const FoundVolumes>& found,
                             const FoundVolumes::ChosenVolume& best, Progress& progress) {
    Result<OpenedStudy> first = loadFound(found, best.index, progress);
    if (first) first->whyThisSeries = best.why;
    if (first || first.error().code == ErrorCode::cancelled) return first;
    std::vector<std::size_t> failed{best.index};
    std::vector<Text> told{notOpened(found->volumes().at(best.index), first.error().message)};
    while (const auto index = found->bestWithout(failed)) {
        Result<OpenedStudy> study = loadFound(found, *index, progress);
        if (!study && study.error().code == ErrorCode::cancelled) return study;
        if (study) {
            study->whyThisSeries = Text("The best volume that can be opened.");
            told.push_back(
                found->areOfOnePatient(*index, best.index)
                    ? Text("The best of the other volumes is shown instead.")
                    : Text("The best of the other volumes is shown instead, which is of another patient."));
            study->messages.insert(study->messages.begin(), told.begin(), told.end());
            return study;
        }
        told.push_back(notOpened(found->volumes().at(*index), study.error().message));
        failed.push_back(*index);
    }
    return first;
}

// The error for a series requested from a source other than DICOM images.
Error hasNoSeries(const std::filesystem::path& path) {
    return {ErrorCode::usage, Text("A series was asked for of what is no folder of DICOM images."),
            path.string(), Text("Ask for none, or give a folder.")};
}

Result<OpenedStudy> openPath(const std::filesystem::path& given, Progress& progress, const OpenRequest& how) {
    // The path is made absolute, because a name without a folder has no parent.
    const std::filesystem::path path = std::filesystem::absolute(given).lexically_normal();
    std::error_code notThere;
    const bool isFile = std::filesystem::is_regular_file(path, notThere);
    if (isFile && formats::isVolumeFileName(path)) {
        if (!how.series.empty()) return hasNoSeries(path);
        return openVolumeFile(path, progress);
    }
    const bool isArchive = isFile && unpack::isArchive(path);
    const bool isOneImage = isFile && !isArchive && !isMediaDirectory(path);
    dicom::ScanOptions scanning{.join = how.join};
    if (how.foundSoFar)
        scanning.glimpsed = [&](dicom::Scan seen) {
            how.foundSoFar(
                std::make_shared<const FoundVolumes>(std::move(seen), FoundVolumes::Extent::soFar));
        };
    MACULA_TRY(ScannedPlace scanned,
               scanPlace(isFile && !isArchive ? path.parent_path() : path, progress, scanning));
    const auto found = foundVolumesOf(std::move(scanned));
    if (auto question = joinQuestionOf(*found); !question.empty())
        return OpenedStudy{.volume = nullptr, .joinQuestion = std::move(question)};
    if (how.foundSoFar) how.foundSoFar(found);
    if (how.asksWhichPatient && how.series.empty() && !isOneImage) {
        if (auto question = whichPatient(*found, path)) return *std::move(question);
    }
    const bool isAsked = !how.series.empty() || isOneImage;  // then no other is opened in its place
    MACULA_TRY(const FoundVolumes::ChosenVolume choice, !how.series.empty()
                                                            ? found->ofSeries(how.series, path)
                                                        : isOneImage ? found->holding(path)
                                                                     : found->best(path));
    if (!isAsked) return loadBest(found, choice, progress);
    MACULA_TRY(OpenedStudy study, loadFound(found, choice.index, progress));
    study.whyThisSeries = choice.why;
    return study;
}

// Turns anything thrown into an error that this study cannot be shown; the window must live on.
template <class Load>
Result<OpenedStudy> withoutExceptions(const StudySource& source, Load load) {
    try {
        return load();
    } catch (const std::exception& thrown) {
        return errorOf(thrown, Text("open this study"), source ? source->string() : std::string());
    }
}

}  // namespace

Result<OpenedStudy> openStudy(const StudySource& source, Progress& progress, const OpenRequest& how) {
    return withoutExceptions(source, [&]() -> Result<OpenedStudy> {
        if (source) return openPath(*source, progress, how);
        if (!how.series.empty()) return hasNoSeries({});
        return openPhantom(progress);
    });
}

Result<OpenedStudy> openFoundVolume(std::shared_ptr<const FoundVolumes> found, std::size_t index,
                                    Progress& progress) {
    return withoutExceptions({}, [&] { return loadFound(std::move(found), index, progress); });
}

Result<OpenedStudy> openVolumeOfFile(std::shared_ptr<const VolumesOfFile> volumes, std::size_t index,
                                     Progress& progress) {
    return withoutExceptions(volumes->file,
                             [&] { return volumeOfFile(std::move(volumes), index, progress); });
}

}  // namespace macula::study
