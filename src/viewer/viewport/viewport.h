// A widget that shows a volume, path traced, with a camera that orbits it.
#pragma once

#include "live/frame/render_thread.h"  // before Qt, see vulkan_window.h
#include "viewer/viewport/vulkan_window.h"

#include <QVulkanInstance>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera/orbit_camera.h"
#include "viewer/overlay/cube_and_scale.h"
#include "viewer/overlay/picture_tool.h"
#include "viewer/viewport/phase_in_3d.h"
#include "viewer/viewport/picture_camera.h"
#include "viewer/viewport/picture_hand.h"
#include "viewer/viewport/picture_overlay.h"
#include "viewer/viewport/rest_goal.h"

namespace macula::viewer {

// Creates a Vulkan instance with the extensions of the window system. deviceNotUsable if this system cannot
// show Vulkan pictures. Needs a QGuiApplication.
Result<gpu::Instance> createInstanceForWindows();

// Owns the render thread and the state that its inputs are made from. Each setter publishes a new input and
// returns at once; results arrive as signals. Lives on the UI thread.
class Viewport : public QWidget {
    Q_OBJECT

  public:
    // `preferredDevice` as in gpu::chooseDevice. `keeper` keeps models between runs; null: they are not kept.
    Viewport(gpu::Instance instance, std::string preferredDevice,
             std::shared_ptr<live::SceneKeeper> keeper = nullptr, QWidget* parent = nullptr);
    ~Viewport() override;

    // Shows a new study, with a camera that looks from `from` and fits its visible part. Volume, drawing and
    // names change at once, so that no volume is ever drawn under another's name. The old picture and its
    // orientation letters leave the screen before the first picture of the new study comes. A null volume
    // shows nothing. After an error that left a picture on screen the window is hidden until the next change
    // of study, drawing or camera. `names` identify patient and study over each picture, unless hidden. Ends
    // a drag.
    void setStudy(std::shared_ptr<const Volume> volume, std::vector<std::string> names,
                  scene::Drawing drawing, std::optional<ViewDirection> from);
    // Shows a phase of the study, with the camera as it is; setStudy() shows the study without phases. The
    // visible part that fit() fits stays that of the open one.
    void setPhase(const PhaseIn3d& phase, scene::Drawing drawing);
    bool showsOtherPhase() const { return input_.volume != open_; }
    const std::shared_ptr<const Volume>& volume() const { return input_.volume; }  // the one that is drawn
    const scene::Drawing& drawing() const { return input_.drawing; }
    void showNames(bool shown);
    bool namesShown() const { return overlay_.showsNames(); }
    void setDrawing(scene::Drawing drawing);
    void setSampleLimit(std::uint32_t samplesPerPixel);
    // When a picture at rest counts as converged, and whether the model waits for that: see live::FrameInput.
    void setRestGoal(const RestGoal& goal);
    void setLiveQuality(const live::LiveQuality& quality);  // the quality of frames in motion
    // Asks for the current model, which arrives as live::ModelSnapshot with the returned number.
    std::uint64_t askForModel(bool withTraining);
    // Whether motion shows the peripheral model (splats), or else small traced pictures.
    void setUsesModel(bool uses);
    // Whether the fovea follows the pointer, or stays in the middle of the picture.
    void setGazeFollowsPointer(bool follows);
    void setPictureSizeHint(QSize pixels);
    // Tools get input in this order before the camera; null entries are ignored. The caller owns them.
    void setTools(std::vector<PictureTool*> tools);
    void updateToolMarks();  // call when their marks have changed
    PictureGeometry geometry() const;
    // Shows cube and scale over each picture, for the camera of that picture.
    void showMarks(bool shown);
    // Switches between parallel rays and perspective; keeps the extent shown at the camera's target.
    void setParallel(bool isParallel) { camera_.setParallel(isParallel); }

    void showFrom(ViewDirection from) { camera_.showFrom(from); }
    // The nearest turntable camera: scene::orbitCameraOf.
    void showFrom(const Camera& camera) { camera_.showFrom(camera); }
    // The new centre of rotation, patient LPS.
    void centreOn(const glm::dvec3& mm) { camera_.centreOn(mm); }
    void fit() { camera_.fit(); }  // fits the visible part, from the present side
    // Arrows, +, -, [, ], F, N (names), B (marks), O and the letters of the standard views. False for any
    // other key.
    bool handleKey(const QKeyEvent& event);

    const scene::OrbitCamera& camera() const { return camera_.now(); }
    // The side of a camera that still fits the visible part; nothing after the camera was moved, or with
    // parallel rays.
    std::optional<ViewDirection> framedFrom() const { return camera_.framedFrom(); }
    // The side from which this study was shown first.
    ViewDirection firstFrom() const { return camera_.firstFrom(); }
    std::uint64_t study() const { return input_.study; }  // see live::FrameShown::study
    // The orientation letters on screen, painted into each picture; empty without one.
    const scene::EdgeLetters& letters() const { return letters_; }
    VulkanWindow& window() { return *window_; }
    QSize pictureSize() const { return window_->pixels(); }
    // Describes this study's picture on screen; null without one.
    const live::FrameShown* frameOnScreen() const { return shown_ ? &*shown_ : nullptr; }
    // The picture on screen and the camera of its marks; nothing without a picture.
    std::optional<MarkedPicture> pictureOnScreen() const;
    // Whether the picture on screen has the current camera (for parallel rays: see standingBefore).
    bool isCameraOnScreen() const {
        const auto picture = input_.volume ? pictureOnScreen() : std::nullopt;
        return picture && picture->camera == standingBefore(toCamera(camera()), input_.volume->worldBox());
    }
    double aspect() const;  // width over height

  Q_SIGNALS:
    void rendered(const macula::live::RenderEvent& event);
    void otherPictureWanted();  // another study, drawing or camera
    void resized();             // the picture
    void namesToggled(bool shown);
    void marksAsked(bool shown);  // by key: the owner of the state calls showMarks
    void parallelChanged(bool isParallel);
    // The place in the picture: -1 to 1, right and up are positive.
    void doubleClicked(QPointF place);
    void cameraRested();                      // at the end of a drag, key or view change
    void windowDragged(QPointF byHeights);    // with the right button, in projections: see scene::dragged
    void transferDragged(QPointF byHeights);  // since the last signal: right and down are positive
    void dropped(const macula::viewer::Dropped& what);
    void keyNotHandled(QKeyEvent* event);

  private:
    void takePhase(const PhaseIn3d& phase);
    void connectWindow();
    void connectHand();
    void publishChange();                                      // the study, drawing or camera has changed
    std::uint64_t publish();                                   // returns the number of the input
    void updateMarks();                                        // updates the marks in the input
    std::optional<ViewDirection> sideAt(QPointF place) const;  // the cube's side there, if the cube is shown
    bool showsProjection() const { return trace::isProjection(input_.drawing.settings.look); }
    bool isCalibrated() const;  // the volume; true without one
    MarkedPicture markedPicture(const Camera& camera) const;
    void onRendered(const live::RenderEvent& event);
    void setLetters(const scene::EdgeLetters& letters);

    QVulkanInstance vulkan_;  // outlives the window
    VulkanWindow* window_;    // owned by container_
    std::unique_ptr<WindowContainer> container_;
    PictureCamera camera_;
    PictureTools tools_;
    PictureHand hand_;
    CameraKeys keys_;
    PictureOverlay overlay_;

    live::FrameInput input_;
    std::shared_ptr<const Volume> open_;  // of setStudy()
    std::vector<std::string> names_;      // of setStudy()
    PhaseIn3d phase_;
    std::uint64_t lastChange_ = 0;  // number of the last publishChange()
    bool gazeFollowsPointer_ = true;
    std::optional<live::FrameShown> shown_;  // the picture on screen
    scene::EdgeLetters letters_;             // the side letters of that picture

    std::unique_ptr<live::RenderThread> renderThread_;
};

}  // namespace macula::viewer
