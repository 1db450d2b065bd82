// Watches folders that a person chose, and says when a study has appeared in one. It opens none by itself.
#pragma once

#include <QObject>
#include <QStringList>
#include <cstddef>
#include <vector>

#include "viewer/context/window_context.h"
#include "viewer/watch/folder_look.h"

class QMenu;

namespace macula::viewer {

class ArrivalBar;
class OpeningController;

// Lives on the UI thread; files are read on others.
class WatchController : public QObject {
    Q_OBJECT

  public:
    WatchController(const WindowContext& context, OpeningController& opening, const QStringList& folders,
                    WatchPace pace);

    ArrivalBar& bar() const { return *bar_; }  // it belongs to the widget that shows it
    void addMenu(QMenu& file);
    void showNames(bool shown);
    QStringList folders() const;
    std::size_t looks() const;  // how often the folder was looked at for which that is least
    void watch(const QString& folder);
    void stopWatching(const QString& folder);

  Q_SIGNALS:
    void foldersChanged(const QStringList& folders);  // to keep

  private:
    void fillMenu();
    void askForFolder();
    void begin(const QString& folder);

    WindowContext context_;
    OpeningController& opening_;
    WatchPace pace_;
    bool namesShown_ = true;
    std::vector<FolderLook*> looks_;
    ArrivalBar* bar_;
    QMenu* menu_ = nullptr;
};

}  // namespace macula::viewer
