// The lights of the window: panel, handles in the picture, files, metering of the exposure, and the list of
// built-in rigs.
#pragma once

#include <QObject>
#include <QScrollArea>

#include "base/result.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"
#include "viewer/lights/lights_editing.h"

class QComboBox;
class QDockWidget;
class QToolBar;

namespace macula::viewer {

class LightsPanel;

// Lives on the UI thread.
class LightsController : public QObject {
    Q_OBJECT

  public:
    explicit LightsController(const WindowContext& context);

    LightsTool& tool() { return tool_; }
    QWidget* panel() const { return scrolls_; }
    void setDock(QDockWidget& dock);  // the panel's dock
    void addList(QToolBar& bar);

  private:
    void save();
    void open();
    void meter();
    void useMetered(const Result<double>& exposure);
    void showChosen();  // selects the session's rig in the list

    WindowContext context_;
    LightsEditing editing_;
    LightsTool tool_;
    LightsPanel* panel_;
    QScrollArea* scrolls_;
    QComboBox* list_ = nullptr;
    BackgroundJob<double> metering_;
};

}  // namespace macula::viewer
