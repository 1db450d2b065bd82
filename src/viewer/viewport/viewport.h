// A widget that shows a volume, path traced, with a camera that orbits it.
#pragma once

#include "live/frame/render_thread.h"  // before Qt, see vulkan_window.h
#include "viewer/viewport/vulkan_window.h"

#include <QTimer>
#include <QVulkanInstance>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera/orbit_camera.h"
#include "viewer/overlay/cube_and_scale.h"
#include "viewer/overlay/painted_text.h"
#include "viewer/overlay/picture_tool.h"
#include "viewer/overlay/tool_marks.h"
#include "viewer/viewport/rest_goal.h"

namespace macula::viewer {

// The Vulkan instance with the extensions of the window system. deviceNotUsable if that cannot show Vulkan
// pictures. Needs a QGuiApplication.
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
    void showNames(bool shown);
    bool namesShown() const { return namesShown_; }
    void setDrawing(scene::Drawing drawing);
    void setSampleLimit(std::uint32_t samplesPerPixel);
    // What counts as converged at rest, and whether the model waits for it: see live::FrameInput.
    void setRestGoal(const RestGoal& goal);
    void setLiveQuality(const live::LiveQuality& quality);  // of frames in motion
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
    void setParallel(bool isParallel);

    void showFrom(ViewDirection from);
    void showFrom(const Camera& camera);  // the nearest turntable camera: scene::orbitCameraOf
    void centreOn(const glm::dvec3& mm);  // the new centre of rotation, patient LPS
    void fit();                           // fits the visible part, from the present side
    // Arrows, +, -, [, ], F, N (names), B (marks), O and the letters of the standard views. False for any
    // other key.
    bool handleKey(const QKeyEvent& event);

    const scene::OrbitCamera& camera() const { return camera_; }
    // The side of a camera that still fits the visible part; nothing after the camera was moved, or with
    // parallel rays.
    std::optional<ViewDirection> framedFrom() const {
        return untouched_ && !camera_.isParallel ? std::optional(framedFrom_) : std::nullopt;
    }
    // The side from which this study was shown first.
    ViewDirection firstFrom() const { return firstFrom_; }
    std::uint64_t study() const { return input_.study; }  // as in FrameShown
    // The orientation letters on screen, painted into each picture; empty without one.
    const scene::EdgeLetters& letters() const { return letters_; }
    VulkanWindow& window() { return *window_; }
    QSize pictureSize() const { return window_->pixels(); }
    // The facts of this study's picture on screen; null without one.
    const live::FrameShown* frameOnScreen() const { return shown_ ? &*shown_ : nullptr; }
    // The picture on screen and the camera of its marks; nothing without a picture.
    std::optional<MarkedPicture> pictureOnScreen() const;
    // Whether the picture on screen has the current camera (for parallel rays: see standingBefore).
    bool isCameraOnScreen() const {
        const auto picture = input_.volume ? pictureOnScreen() : std::nullopt;
        return picture && picture->camera == standingBefore(toCamera(camera_), input_.volume->worldBox());
    }
    double aspect() const;  // width over height

  signals:
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
    void connectWindow();
    void setCamera(const scene::OrbitCamera& camera);
    void publishChange();  // of study, drawing or camera
    void applyDrag(VulkanWindow::Drag drag, QPointF byPixels);
    PicturePlace placeAt(QPointF place, bool withShift) const;
    bool grab(QPointF place, bool withShift);
    bool moveFocus(const QKeyEvent& event);  // returns whether it was Tab
    void onPointed(QPointF place);
    void endHold();  // of a tool
    void onWheel(double notches, bool withShift);
    std::optional<ViewDirection> sideAt(QPointF place) const;  // of the cube, if it is shown
    void turnToSide(QPointF place);
    void fly(double notches);
    bool handleRoll(const QKeyEvent& event);
    void nudge();               // an input without an end event: a key, a wheel notch
    std::uint64_t publish();    // its number
    bool isCalibrated() const;  // the volume; true without one
    double sceneDiagonalMm() const;
    std::vector<glm::dvec3> outlineMm() const;  // of what the camera fits
    void onOutline(const live::OutlineFound& found);
    void onRendered(const live::RenderEvent& event);
    void setLetters(const scene::EdgeLetters& letters);
    void updateText();
    void updateMarks();
    void layOut();

    QVulkanInstance vulkan_;  // outlives the window
    VulkanWindow* window_;    // owned by container_
    QWidget* container_ = nullptr;
    scene::EdgeLetters letters_;  // of the picture on screen
    QTimer nudgeEnds_;

    std::vector<std::string> names_;  // of the study
    bool namesShown_ = true;
    std::vector<PictureTool*> tools_;
    PictureTool* holder_ = nullptr;  // the tool that holds
    // The sources of input_.text.
    LinesOver textLines_;
    QSize textPx_;
    double textPixelRatio_ = 0.0;
    double textFontScale_ = 0.0;
    bool marksShown_ = true;
    struct Marked {
        MarkedPicture picture;
        bool hasCube = true;
        double fontScale = 1.0;
        std::vector<ToolMark> ofTools = {};

        bool operator==(const Marked&) const = default;
    };
    std::shared_ptr<const live::PictureText> paintStanding(const Marked& marked) const;
    std::optional<Marked> marked_;                       // the sources of input_.marks
    std::shared_ptr<const live::PictureText> standing_;  // letters, cube and scale: a part of it
    std::optional<live::FrameShown> shown_;              // the picture on screen

    scene::OrbitCamera camera_;
    live::FrameInput input_;
    std::uint64_t lastChange_ = 0;  // its number
    bool dragging_ = false;
    glm::dvec2 pointedAt_{0.0};  // as FrameInput::gaze
    bool gazeFollowsPointer_ = true;
    ViewDirection firstFrom_ = ViewDirection::anterior;
    ViewDirection framedFrom_ = ViewDirection::anterior;
    bool untouched_ = true;  // the camera was not moved since it was framed
    std::shared_ptr<const std::vector<glm::dvec3>>
        outline_;  // of the study as it was last drawn; null before

    std::unique_ptr<live::RenderThread> renderThread_;
};

}  // namespace macula::viewer
