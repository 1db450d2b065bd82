// Watches folders that a person chose, and says when a study has appeared in one. It opens none by itself.
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <chrono>
#include <memory>
#include <vector>

#include "study/watch/watched_folder.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QMenu;

namespace macula::viewer {

class ArrivalBar;
class OpeningController;

// How often folders are looked at, and how long nothing may change in a study before it counts as whole.
struct WatchPace {
    std::chrono::milliseconds every{3000};
    std::chrono::milliseconds quiet{6000};
};

// Looks again and again, since network file systems do not tell of changes; a look that takes long is
// followed by a longer pause. Lives on the UI thread; files are read on another.
class WatchController : public QObject {
    Q_OBJECT

  public:
    WatchController(const WindowContext& context, OpeningController& opening, const QStringList& folders,
                    WatchPace pace);

    ArrivalBar& bar() const { return *bar_; }  // it belongs to the widget that shows it
    void addMenu(QMenu& file);
    void showNames(bool shown);
    const QStringList& folders() const { return folders_; }
    std::size_t looks() const { return looks_; }  // at all folders, so far
    void watch(const QString& folder);
    void stopWatching(const QString& folder);

  Q_SIGNALS:
    void foldersChanged(const QStringList& folders);  // to keep

  private:
    // What one look at all folders found.
    struct Looked {
        std::vector<study::ArrivedStudy> arrived;
        QStringList absent;  // folders that cannot be read now
        std::chrono::milliseconds took{0};
    };

    void fillMenu();
    void askForFolder();
    void begin(const QString& folder);
    void look();
    void take(const Result<Looked>& looked);

    WindowContext context_;
    OpeningController& opening_;
    WatchPace pace_;
    QStringList folders_;
    QStringList absent_;
    std::size_t looks_ = 0;
    bool namesShown_ = true;
    std::vector<std::shared_ptr<study::WatchedFolder>> watched_;  // only a look in progress uses them
    ArrivalBar* bar_;
    QMenu* menu_ = nullptr;
    QTimer timer_;
    BackgroundJob<Looked> look_;
};

}  // namespace macula::viewer
