// Sends what Macula makes of the open study, and files, to an archive; and what waits for one.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <chrono>
#include <deque>
#include <functional>
#include <vector>

#include "viewer/archive/objects_to_send.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QAction;
class QMenu;

namespace macula::viewer {

class ArchiveController;
class MeasurementsController;
class OpeningController;
class PicturesController;
class PresentationsController;
class QueueDialog;
class SegmentationsController;
class SendDialog;
class SettingsController;
class WaitingBar;
class WorkBar;

// One after another, in the background. What could not be stored waits in the queue, and is offered again at
// the start of the program, and when the archive answers again; it is never sent unless a person asks for it.
// Lives on the UI thread.
class SendController : public QObject {
    Q_OBJECT

  public:
    struct Uses {  // all of it outlives the controller
        ArchiveController& archives;
        MeasurementsController& measurements;
        OpeningController& opening;
        PicturesController& pictures;
        PresentationsController& presentations;
        SegmentationsController& segmentations;
        SettingsController& settings;
    };
    SendController(const WindowContext& context, const Uses& uses);

    static constexpr bool kKeepsRest = true;  // see QuitController
    WorkBar* bar() const { return bar_; }     // while something is sent
    WaitingBar* waiting() const { return waiting_; }
    void addActions(QMenu& file);
    void showNames(bool shown);
    // How often archives for which something waits are asked whether they answer.
    void setAsksEvery(std::chrono::milliseconds time);

    QString unfinished() const;  // a sentence; empty: nothing is being sent
    void cancel();

  Q_SIGNALS:
    void written();  // nothing is being sent any more

  private:
    using Work = BackgroundJob<ObjectsSent>::Work;

    void askWhatToSend();
    QString usualArchive(const QStringList& archives) const;
    void askForFiles(SendDialog& dialog, bool folder);
    void send(const SendDialog& dialog, ObjectsToSend onScreen);
    void sendQueued(const std::vector<study::OutboxEntry>& entries, study::Outbox::Which which);
    void sendChosen(const std::vector<study::OutboxEntry>& entries);
    void begin(const QString& told, Work work);
    void beginNext();
    void tell(const Result<ObjectsSent>& outcome);
    void readQueue(bool offers);
    void showQueue();
    void remove(const std::vector<study::OutboxEntry>& entries);
    void askArchives();
    void onAnswer(const QString& archive);
    bool waitsFor(const QString& archive) const;

    WindowContext context_;
    Uses uses_;
    WorkBar* bar_;
    WaitingBar* waiting_;
    QAction* queueAction_ = nullptr;
    QPointer<QueueDialog> queue_;
    bool namesShown_ = true;
    bool offersNext_ = false;  // what was read of the queue
    QTimer asks_;
    std::vector<study::OutboxEntry> entries_;
    struct Job {
        QString told;
        Work work;
    };
    std::deque<Job> waitingJobs_;
    BackgroundJob<ObjectsSent> sending_;
    BackgroundJob<std::vector<study::OutboxEntry>> reading_;
    BackgroundJob<std::vector<std::string>> asking_;  // the archives that answer
};

}  // namespace macula::viewer
