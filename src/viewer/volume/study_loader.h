// Opens studies in the background.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "live/store/study_keeper.h"
#include "study/open/opened_study.h"
#include "study/open/phases.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// One load at a time, on a thread of its own. A new one cancels the one before, whose outcome is not
// reported. Lives on the UI thread, and so do its signals.
class StudyLoader : public QObject {
    Q_OBJECT

  public:
    explicit StudyLoader(QObject* parent = nullptr);

    // The keeper of the states in which studies were left; null: none.
    void setKeeper(std::shared_ptr<live::StudyKeeper> keeper) { keeper_ = std::move(keeper); }
    // Further slow work on the opened study, on the loading thread; null: none.
    using Prepare = std::function<void(const study::OpenedStudy&)>;
    void setPrepare(Prepare prepare) { prepare_ = std::move(prepare); }

    void open(study::StudySource source, bool join = false);
    void open(study::PhaseSource source, std::size_t volume);
    void cancel();  // `cancelled` follows
    const study::StudySource& source() const {
        return source_;
    }  // the source opened last; nothing for a found volume
    bool loading() const { return job_.running(); }
    bool atRest() const { return job_.atRest(); }  // cancelled jobs have ended, too

  Q_SIGNALS:
    void began();
    void progressed(const QString& stage, double fraction);
    // The content of the folder so far; finally all of it, before a volume is loaded.
    void found(std::shared_ptr<const macula::study::FoundVolumes> found);
    void loaded(const macula::study::OpenedStudy& study);
    void askedToJoin(const QString& path, const QString& question);  // open(path, true) is yes
    // The file that was to be opened is an imaging manifest; `cancelled` follows.
    void foundManifest(const QString& path);
    void failed(const macula::Error& error);
    void cancelled();

  private:
    study::FoundSoFar tellsOf(std::uint64_t opening);
    void tellOutcome(const Result<study::OpenedStudy>& outcome);

    BackgroundJob<study::OpenedStudy> job_;
    study::StudySource source_;
    std::uint64_t opening_ = 0;  // number of the last opening; others emit nothing
    std::shared_ptr<live::StudyKeeper> keeper_;
    Prepare prepare_;
};

}  // namespace macula::viewer
