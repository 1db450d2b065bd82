// Opens a folder without keeping anybody waiting.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "live/store/model_keeper.h"
#include "study/open/opened_study.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// One load at a time, on a thread of its own. A new one cancels the one before, whose outcome is not
// reported. Lives on the UI thread, and so do its signals.
class StudyLoader : public QObject {
    Q_OBJECT

  public:
    explicit StudyLoader(QObject* parent = nullptr);

    // Who knows how studies were left; null: nobody does.
    void setKeeper(std::shared_ptr<app::ModelKeeper> keeper) { keeper_ = std::move(keeper); }
    // What else takes long and is done to what was opened, on the thread that opens it; null: nothing.
    using Prepare = std::function<void(const app::OpenedStudy&)>;
    void setPrepare(Prepare prepare) { prepare_ = std::move(prepare); }

    void open(app::StudySource source, bool join = false);
    void open(std::shared_ptr<const app::FoundVolumes> found, std::size_t index);
    void cancel();  // `cancelled` follows
    const app::StudySource& source() const {
        return source_;
    }  // that was opened last; nothing: a volume found
    bool loading() const { return job_.running(); }
    bool atRest() const { return job_.atRest(); }  // cancelled ones have noticed, too

  signals:
    void began();
    void progressed(const QString& stage, double fraction);
    // What the folder holds, so far; then all of it, before a volume of it is there.
    void found(std::shared_ptr<const macula::app::FoundVolumes> found);
    void loaded(const macula::app::OpenedStudy& study);
    void askedToJoin(const QString& path, const QString& question);  // open(path, true) is yes
    void failed(const macula::Error& error);
    void cancelled();

  private:
    app::FoundSoFar tellsOf(std::uint64_t opening);
    void tellOutcome(const Result<app::OpenedStudy>& outcome);

    BackgroundJob<app::OpenedStudy> job_;
    app::StudySource source_;
    std::uint64_t opening_ = 0;  // the number of the last; of others nothing more is told
    std::shared_ptr<app::ModelKeeper> keeper_;
    Prepare prepare_;
};

}  // namespace macula::viewer
