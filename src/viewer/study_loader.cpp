#include "viewer/study_loader.h"

#include <utility>

#include "app/study/found_volumes.h"

namespace macula::viewer {

StudyLoader::StudyLoader(QObject* parent)
    : QObject(parent),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          emit progressed(QString::fromStdString(update.stage), update.fraction);
                      },
                  .ended = [this](const Result<app::OpenedStudy>& outcome) { tellOutcome(outcome); }}) {}

void StudyLoader::open(app::StudySource source, bool join) {
    source_ = source;
    job_.start([source = std::move(source), join](Progress& progress) {
        return app::openStudy(source, progress, join);
    });
    emit began();
}

void StudyLoader::open(std::shared_ptr<const app::FoundVolumes> found, std::size_t index) {
    job_.start([found = std::move(found), index](Progress& progress) {
        return app::openFoundVolume(found, index, progress);
    });
    emit began();
}

void StudyLoader::cancel() {
    if (job_.cancel()) emit cancelled();
}

void StudyLoader::tellOutcome(const Result<app::OpenedStudy>& outcome) {
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
