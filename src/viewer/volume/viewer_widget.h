// A 3D view of a session's volume as a widget, also for other programs.
#pragma once

#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <QWidget>
#include <memory>
#include <string>

#include "viewer/editor/study_editor.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

struct ViewerWidgetOptions {
    std::string device = {};                         // its name, see gpu::chooseDevice
    std::shared_ptr<live::SceneKeeper> keeper = {};  // keeps models between runs; null: writes nothing
    std::optional<ViewDirection> firstView = {};     // nothing: scene::usualView
    bool showsNames = true;                          // patient and study over the picture
};

// Shows the session's study as panels of the same session choose, such as StudyBrowser, SliceView,
// TransferFunctionEditor and ClipPanel. Has no global state, and only the keeper writes files.
// tests/consumer/qt_host is an example program.
class ViewerWidget : public QWidget {
    Q_OBJECT

  public:
    // The session must outlive it. `instance` comes from createInstanceForWindows.
    ViewerWidget(StudyEditor& session, gpu::Instance instance, ViewerWidgetOptions options = {},
                 QWidget* parent = nullptr);
    ~ViewerWidget() override;

    // The session's state with the current camera; setState takes one of the same study: see
    // ShownVolume::take. live::toJson and scene::studyStateFromJson convert it to and from text.
    scene::StudyState state() const;
    Result<void> setState(const scene::StudyState& state);

    Viewport& viewport() { return *viewport_; }
    ShownVolume& shown() { return *shown_; }

  Q_SIGNALS:
    void frameShown(const macula::live::FrameShown& frame);
    void failed(const macula::Error& error);  // no picture, or voxels could not be hidden

  private:
    void onStudyShown();

    StudyEditor& session_;
    std::optional<ViewDirection> firstView_;
    ShownVolume* shown_;
    Viewport* viewport_;
};

}  // namespace macula::viewer
