#include "viewer/volume/study_loader.h"

#include <chrono>
#include <system_error>
#include <utility>

#include "dicom/manifest/imaging_manifest.h"
#include "formats/volume_file.h"
#include "study/open/found_volumes.h"
#include "viewer/jobs/newest_posted.h"
#include "viewer/jobs/post.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

constexpr std::chrono::milliseconds kPatience{2000};  // longer waits would keep a person from the images

Result<study::OpenedStudy> completed(Result<study::OpenedStudy> study,
                                     const std::shared_ptr<live::StudyKeeper>& keeper,
                                     const StudyLoader::Prepare& prepare) {
    if (!study || !study->volume) return study;
    if (keeper) study->stateAsLeft = keeper->stateOf(study->volume, kPatience).value_or("");
    if (prepare) prepare(*study);
    return study;
}

// Looked at before its folder is: that of a manifest may be one of downloads, and large.
bool isManifest(const std::filesystem::path& path) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(path, failure) || formats::isVolumeFileName(path)) return false;
    const dicom::HeaderFile file = dicom::readHeader(path);
    return file.header && dicom::isImagingManifest(*file.header);
}

}  // namespace

StudyLoader::StudyLoader(QObject* parent)
    : QObject(parent),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                      },
                  .ended = [this](const Result<study::OpenedStudy>& outcome) { tellOutcome(outcome); }}) {}

void StudyLoader::open(study::StudySource source, bool join) {
    source_ = source;
    job_.start([this, source = std::move(source), join, keeper = keeper_, prepare = prepare_,
                tells = tellsOf(++opening_),
                opening = opening_](Progress& progress) -> Result<study::OpenedStudy> {
        if (source && isManifest(*source)) {
            post(this, [this, opening, path = QString::fromStdString(source->string())] {
                if (opening == opening_ && loading()) Q_EMIT foundManifest(path);
            });
            return Error{ErrorCode::cancelled, Text("Loading was cancelled."), {}, {}};
        }
        return completed(study::openStudy(source, progress, {.join = join, .foundSoFar = tells}), keeper,
                         prepare);
    });
    Q_EMIT began();
}

// Called on other threads. The job's end uses the same queue, so it arrives after all of these.
study::FoundSoFar StudyLoader::tellsOf(std::uint64_t opening) {
    using Found = std::shared_ptr<const study::FoundVolumes>;
    return NewestPosted<Found>(this, [this, opening](const Found& volumes) {
        if (opening == opening_ && loading()) Q_EMIT found(volumes);
    });
}

void StudyLoader::open(study::PhaseSource source, std::size_t volume) {
    ++opening_;
    source_.reset();
    job_.start(
        [source = std::move(source), volume, keeper = keeper_, prepare = prepare_](Progress& progress) {
            return completed(study::openPhase(source, volume, progress), keeper, prepare);
        });
    Q_EMIT began();
}

void StudyLoader::cancel() {
    if (job_.cancel()) Q_EMIT cancelled();
}

void StudyLoader::tellOutcome(const Result<study::OpenedStudy>& outcome) {
    if (outcome && !outcome->volume) {
        Q_EMIT askedToJoin(QString::fromStdString(source_.value_or("").string()),
                           inWindowsLanguage(outcome->joinQuestion));
    } else if (outcome) {
        Q_EMIT loaded(*outcome);
    } else if (outcome.error().code == ErrorCode::cancelled) {
        Q_EMIT cancelled();
    } else {
        Q_EMIT failed(outcome.error());
    }
}

}  // namespace macula::viewer
