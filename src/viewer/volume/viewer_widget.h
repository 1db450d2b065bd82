// The volume of a session in 3D, as a widget by itself: for windows of other programs too.
#pragma once

#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <QWidget>
#include <memory>
#include <string>

#include "viewer/session/viewer_session.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

struct ViewerWidgetOptions {
    std::string device = {};                        // as in gpu::chooseDevice
    std::shared_ptr<app::SceneKeeper> keeper = {};  // of models between runs; null: nothing is written
    std::optional<ViewDirection> firstView = {};    // nothing: app::usualView
    bool showsNames = true;                         // patient and study over the picture
};

// Shows the study of the session, and whatever panels that look at the same session choose. Others are
// StudyBrowser, SliceView, TransferFunctionEditor and ClipPanel. Nothing is global, and nothing is written
// but by the keeper. tests/consumer/qt_host is a program of it.
class ViewerWidget : public QWidget {
    Q_OBJECT

  public:
    // The session must outlive it. `instance` of createInstanceForWindows.
    ViewerWidget(ViewerSession& session, gpu::Instance instance, ViewerWidgetOptions options = {},
                 QWidget* parent = nullptr);
    ~ViewerWidget() override;

    // All that was chosen, with the camera of now; and another one of the same study: see ShownVolume::take.
    // app::toJson and app::studyStateFromJson make text of it, and the reverse.
    app::StudyState state() const;
    Result<void> setState(const app::StudyState& state);

    Viewport& viewport() { return *viewport_; }
    ShownVolume& shown() { return *shown_; }

  signals:
    void frameShown(const macula::app::FrameShown& frame);
    void failed(const macula::Error& error);  // there is no picture, or something could not be hidden

  private:
    void onStudyShown();

    ViewerSession& session_;
    std::optional<ViewDirection> firstView_;
    ShownVolume* shown_;
    Viewport* viewport_;
};

}  // namespace macula::viewer
