// The mouse in the 3D picture: tools may take its drags and wheel, otherwise the camera gets them.
#pragma once

#include "viewer/viewport/vulkan_window.h"  // before Qt, see there

#include <QCursor>
#include <QObject>
#include <QPointF>
#include <QTimer>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "viewer/overlay/picture_tool.h"
#include "viewer/viewport/picture_camera.h"

namespace macula::viewer {

// The tools of the 3D picture, and the one that has taken hold of the drag. Asks the tools in their order;
// the caller owns them.
class PictureTools {
  public:
    void set(std::vector<PictureTool*> tools);  // null entries are ignored; gives up a hold

    bool isHolding() const { return holder_ != nullptr; }
    bool changesPicture() const { return holder_->changesPicture(); }  // whether the holding tool does
    bool wouldHold(const PicturePlace& place) const;                   // by their cursors; no tool takes hold
    bool press(const PicturePlace& place);                             // returns whether a tool took hold
    // The next three do nothing without a hold.
    void move(const PicturePlace& place);
    void release(const PicturePlace& place);
    void giveUp();

    // The cursor of the first tool that has one. Later tools do not see the pointer.
    std::optional<Qt::CursorShape> cursorAt(const PicturePlace& place) const;
    bool turnWheel(double notches, const PictureGeometry& picture) const;  // returns whether a tool used it
    std::vector<ToolMark> marks(const PictureGeometry& picture) const;

  private:
    std::vector<PictureTool*> tools_;
    PictureTool* holder_ = nullptr;
};

class PictureHand : public QObject {
    Q_OBJECT

  public:
    struct Parts {  // outlive this
        VulkanWindow& window;
        PictureCamera& camera;
        PictureTools& tools;
    };
    // Functions that return the current facts of the picture.
    struct Picture {
        std::function<bool()> hasStudy;
        std::function<bool()> isProjection;
        std::function<bool()> isOnScreen;  // the picture on screen has the present camera
        std::function<PictureGeometry()> geometry;
    };
    PictureHand(const Parts& parts, Picture picture);

    bool isMoving() const { return isDragging_ || nudgeEnds_.isActive(); }  // then frames must be fast
    void nudge() { nudgeEnds_.start(); }  // an input without an end event: a key, a wheel notch
    glm::dvec2 pointedAt() const { return pointedAt_; }  // as FrameInput::gaze

  Q_SIGNALS:
    void rested();                            // at the end of a drag or of nudges
    void windowDragged(QPointF byHeights);    // a drag in projections
    void transferDragged(QPointF byHeights);  // the same drag in all other looks

  private:
    void listen();
    PicturePlace placeAt(QPointF place, bool withShift) const;
    bool grab(QPointF place, bool withShift);
    void drag(VulkanWindow::Drag drag, QPointF byPixels);
    void point(QPointF place);
    void turnWheel(double notches, bool withShift);
    void fly(double notches);

    Parts parts_;
    Picture picture_;
    bool isDragging_ = false;
    QTimer nudgeEnds_;
    glm::dvec2 pointedAt_{0.0};
};

}  // namespace macula::viewer
