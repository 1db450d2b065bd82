// Saves the window's peripheral model as a file.
#pragma once

#include <QObject>
#include <QString>

#include "viewer/context/window_context.h"

class QMenu;

namespace macula::viewer {

class ModelExport;
class WorkBar;

// Lives on the UI thread.
class ModelsController : public QObject {
    Q_OBJECT

  public:
    explicit ModelsController(const WindowContext& context);

    WorkBar* bar() const { return bar_; }
    void addActions(QMenu& file);

    QString unfinished() const;  // a sentence; empty: nothing is being written
    void cancel();

  Q_SIGNALS:
    void written();

  private:
    void askWhereToSave();

    WindowContext context_;
    ModelExport* export_;
    WorkBar* bar_;
};

}  // namespace macula::viewer
