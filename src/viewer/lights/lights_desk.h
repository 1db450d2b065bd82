// Joins the lights of the window: panel, handles in the picture, files, and metering of the exposure.
#pragma once

#include <QFileDialog>
#include <QObject>
#include <QScrollArea>
#include <functional>
#include <string>

#include "pictures/view_picture.h"
#include "viewer/jobs/background_job.h"
#include "viewer/lights/lights_editing.h"
#include "viewer/lights/lights_tool.h"

namespace macula::viewer {

class LightsPanel;

// The window's services. `ask` opens a dialog and remembers its folder; `folder` is where one begins.
struct LightsHost {
    std::function<pictures::ViewPicture()> seen;  // the current 3D picture, at any size
    std::function<void(QFileDialog*, std::function<void(const QString&)>)> ask;
    std::function<QString()> folder;
    std::string device = {};  // its name, see gpu::chooseDevice
};

// Session and window outlive it.
class LightsDesk : public QObject {
    Q_OBJECT

  public:
    LightsDesk(StudyEditor& session, LightsHost host, QWidget* window);

    LightsTool& tool() { return tool_; }
    QWidget* column() const { return scrolls_; }  // the panel
    void setPanelOpen(bool open) { editing_.setPanelOpen(open); }
    bool isMetering() const { return metering_.running(); }

  Q_SIGNALS:
    void marksChanged();  // the handles over the picture
    void told(const QString& sentence);
    void failed(const macula::Error& error);

  private:
    void save();
    void open();
    void meter();
    void useMetered(const Result<double>& exposure);

    StudyEditor& session_;
    LightsHost host_;
    QWidget* window_;
    LightsEditing editing_;
    LightsTool tool_;
    LightsPanel* panel_;
    QScrollArea* scrolls_;
    BackgroundJob<double> metering_;
};

}  // namespace macula::viewer
