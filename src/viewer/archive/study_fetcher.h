// Fetches studies in the background, one after another.
#pragma once

#include <QObject>
#include <QString>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>

#include "net/archive/query.h"
#include "study/archive/fetched_study.h"
#include "viewer/archive/archive_way.h"
#include "viewer/jobs/background_job.h"
#include "viewer/status/time_left.h"

namespace macula::viewer {

class WorkBar;

// What becomes of a study once it is there. Those that a person waits for come before those that are only
// kept, and interrupt them: these go on later from where they stopped.
enum class FetchFor { show, beside, keep };

struct FetchOrder {
    net::FoundStudy study;
    ArchiveWay way;
    FetchFor purpose = FetchFor::show;
    std::string besideOf = {};  // FetchFor::beside: the UID of the study that was open
};

// Lives on the UI thread.
class StudyFetcher : public QObject {
    Q_OBJECT

  public:
    explicit StudyFetcher(QObject* parent);

    WorkBar* bar() const { return bar_; }  // while studies are fetched

    // A study that is being fetched or waits is not fetched twice; its purpose becomes the more urgent one.
    void fetch(FetchOrder order);
    // The one under way, and those that a person did not wait for. Returns whether there was one.
    bool cancel();

    bool running() const { return current_.has_value(); }
    // The study that arrives now; null without one.
    const FetchOrder* current() const { return current_ ? &*current_ : nullptr; }

  Q_SIGNALS:
    void arrived(const macula::viewer::FetchOrder& order, const macula::study::Arrival& arrival);
    void ended(const macula::viewer::FetchOrder& order,
               const macula::Result<macula::study::FetchedStudy>& fetched);
    void cancelled();

  private:
    void startNext();
    void finish(const Result<study::FetchedStudy>& fetched);
    void showProgress(const ProgressUpdate& update);

    WorkBar* bar_;
    std::deque<FetchOrder> waiting_;  // the most urgent first
    std::optional<FetchOrder> current_;
    std::uint64_t number_ = 0;  // of the current one
    TimeLeft timeLeft_;
    QString stage_;
    BackgroundJob<study::FetchedStudy> job_;
};

}  // namespace macula::viewer
