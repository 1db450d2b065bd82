#include "viewer/loader_job.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include "base/phantom.h"
#include "dicom/loader.h"
#include "dicom/media_directory.h"
#include "dicom/messages.h"
#include "dicom/volume_file.h"
#include "viewer/found_volumes.h"

namespace macula::viewer {

namespace {

Result<LoadedStudy> loadPhantom(Progress& progress) {
    progress.beginStage("Making the phantom", 1);
    auto volume = std::make_shared<const Volume>(phantom::make());
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "Loading was cancelled.", {}, {}};
    progress.advance();
    return LoadedStudy{.volume = std::move(volume),
                       .identity = {.series = "Built-in phantom", .isOfNobody = true},
                       .description = "Built-in phantom"};
}

// NIfTI and its kin: one volume, and nobody's name in it.
Result<LoadedStudy> loadVolumeFile(const std::filesystem::path& path, Progress& progress) {
    MACULA_TRY(std::shared_ptr<const Volume> volume, dicom::readVolumeFile(path, progress));
    const std::string name = path.filename().string();
    return LoadedStudy{
        .volume = in16Bits(std::move(volume)), .identity = {.series = "File " + name}, .description = name};
}

bool isMediaDirectory(const std::filesystem::path& file) {
    return dicom::readMediaDirectory(file).ok();
}

// Returns the question whether images are one series (dicom::key::kUidPerSlice), when the folder holds no
// volume without an answer; else nothing.
std::string joinQuestionOf(const FoundVolumes& found) {
    const auto& messages = found.scan().messages;
    const auto asked = std::ranges::find(messages, dicom::key::kUidPerSlice, &Message::key);
    return found.volumes().empty() && asked != messages.end() ? asked->sentence : std::string();
}

Result<LoadedStudy> loadPath(const std::filesystem::path& given, Progress& progress, bool join) {
    // Of a name without a folder the parent would be empty.
    const std::filesystem::path path = std::filesystem::absolute(given).lexically_normal();
    std::error_code notThere;
    const bool isFile = std::filesystem::is_regular_file(path, notThere);
    if (isFile && dicom::isVolumeFileName(path)) return loadVolumeFile(path, progress);
    const bool isOneImage = isFile && !isMediaDirectory(path);
    MACULA_TRY(dicom::Scan scan,
               dicom::scanFolder(isFile ? path.parent_path() : path, progress, {.join = join}));
    const auto found = std::make_shared<const FoundVolumes>(std::move(scan));
    if (auto question = joinQuestionOf(*found); !question.empty())
        return LoadedStudy{.volume = nullptr, .joinQuestion = std::move(question)};
    MACULA_TRY(const FoundVolumes::Choice choice, isOneImage ? found->holding(path) : found->best(path));
    MACULA_TRY(LoadedStudy study, loadFoundVolume(found, choice.index, progress));
    study.whyThisSeries = choice.why;
    return study;
}

}  // namespace

Result<LoadedStudy> loadFoundVolume(std::shared_ptr<const FoundVolumes> found, std::size_t index,
                                    Progress& progress) {
    const FoundVolume& chosen = found->volumes().at(index);
    MACULA_TRY(std::shared_ptr<const Volume> volume,
               dicom::loadVolume(*chosen.series, *chosen.stack, progress));
    LoadedStudy study{.volume = in16Bits(std::move(volume)),
                      .identity = identityOf(chosen),
                      .description = chosen.series->description,
                      .whyThisSeries = "The volume that was chosen.",
                      .volumeTitles = found->titles(),
                      .volumeIndex = index};
    const auto tell = [&](const std::vector<Message>& messages) {
        for (const Message& message : messages) {
            if (message.severity != Severity::info) study.messages.push_back(message.sentence);
        }
    };
    const dicom::Scan& scan = found->scan();
    tell(scan.messages);
    tell(chosen.series->messages);
    tell(chosen.stack->messages);
    tell(study.volume->provenance().messages);
    if (!scan.skipped.empty()) {
        study.messages.push_back(std::to_string(scan.skipped.size()) +
                                 (scan.skipped.size() == 1 ? " file was" : " files were") +
                                 " left out; `macula info` on the folder says why.");
    }
    study.found = std::move(found);
    return study;
}

namespace {

// Nothing is known of what is thrown but that this study cannot be shown; the window must live on.
template <class Load>
Result<LoadedStudy> withoutExceptions(const StudySource& source, Load load) {
    try {
        return load();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory,
                     "There is not enough memory for this study.",
                     {},
                     "Close other programs, or open a smaller series."};
    } catch (const std::exception&) {
        return Error{ErrorCode::inputNotUsable, "The study could not be opened.",
                     source ? source->string() : std::string(),
                     "Run `macula info` on the folder to find out what is wrong with it."};
    }
}

}  // namespace

Result<LoadedStudy> loadStudy(const StudySource& source, Progress& progress, bool join) {
    return withoutExceptions(
        source, [&] { return source ? loadPath(*source, progress, join) : loadPhantom(progress); });
}

StudyLoader::StudyLoader(QObject* parent)
    : QObject(parent),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          emit progressed(QString::fromStdString(update.stage), update.fraction);
                      },
                  .ended = [this](const Result<LoadedStudy>& outcome) { tellOutcome(outcome); }}) {}

void StudyLoader::open(StudySource source, bool join) {
    source_ = source;
    job_.start(
        [source = std::move(source), join](Progress& progress) { return loadStudy(source, progress, join); });
    emit began();
}

void StudyLoader::open(std::shared_ptr<const FoundVolumes> found, std::size_t index) {
    job_.start([found = std::move(found), index](Progress& progress) {
        return withoutExceptions({}, [&] { return loadFoundVolume(found, index, progress); });
    });
    emit began();
}

void StudyLoader::cancel() {
    if (job_.cancel()) emit cancelled();
}

void StudyLoader::tellOutcome(const Result<LoadedStudy>& outcome) {
    if (outcome && !outcome->volume) {
        emit askedToJoin(QString::fromStdString(source_.value_or("").string()),
                         QString::fromStdString(outcome->joinQuestion));
    } else if (outcome) {
        emit loaded(*outcome);
    } else if (outcome.error().code == ErrorCode::cancelled) {
        emit cancelled();
    } else {
        emit failed(outcome.error());
    }
}

}  // namespace macula::viewer
