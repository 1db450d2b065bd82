// Saves the measurements of the open study to a file, and removes them.
#pragma once

#include <QObject>

#include "viewer/context/window_context.h"

class QMenu;

namespace macula::viewer {

// Lives on the UI thread.
class MeasurementsController : public QObject {
    Q_OBJECT

  public:
    explicit MeasurementsController(const WindowContext& context);

    void addFileActions(QMenu& file);
    void addEditActions(QMenu& edit);

  private:
    void askWhereToSave();

    WindowContext context_;
};

}  // namespace macula::viewer
