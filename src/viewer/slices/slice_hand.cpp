#include "viewer/slices/slice_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace macula::viewer {

namespace {

constexpr double kClickPx = 3.0;            // a right click moves no farther
constexpr double kDragZoomPerHeight = 6.0;  // magnification by a drag up over the pane's height

}  // namespace

bool SliceHand::isUndoStep(Drag drag) {
    return drag == Drag::crosshair || drag == Drag::window || drag == Drag::handle || drag == Drag::clip ||
           drag == Drag::turn || drag == Drag::curve;
}

// False for tools that act on the whole picture.
bool SliceHand::takesHold() const {
    return tool_ != SliceTool::window && tool_ != SliceTool::zoom && tool_ != SliceTool::pan &&
           tool_ != SliceTool::segment;
}

bool SliceHand::press(Qt::MouseButton button, const QPointF& place, const SliceRequest& shown) {
    pressedAt_ = lastAt_ = place;
    hasDragged_ = false;
    scrollRestPx_ = 0.0;
    button_ = button;
    switch (button) {
        case Qt::LeftButton:
            pressLeft(place, shown);
            return true;
        case Qt::RightButton:
            drag_ = dragOf(mouseProfile().right);
            return true;
        case Qt::MiddleButton:
            drag_ = dragOf(mouseProfile().middle);
            return true;
        default:
            return false;
    }
}

void SliceHand::pressLeft(const QPointF& place, const SliceRequest& shown) {
    PaneMeasurements& measurements = parts_.measurements;
    if (measurements.isDrawing()) {
        measurements.pressDrawing(shown.worldFromPane(place));
        drag_ = measurements.isDrawing() ? Drag::draw : Drag::none;
        return;
    }
    if (tool_ == SliceTool::segment) return pressBrush(place, shown);
    if (takeClip(place, shown) || takeMeasurement(place, shown) || takeRing(place, shown)) return;
    measurements.deselect();
    if (tool_ == SliceTool::curve && shown.showsStudy()) parts_.curve.hold(place, shown);
    if (measures(tool_)) {
        if (!shown.showsStudy()) return;  // measurements are stored with the study
        measurements.beginDrawing(tool_, place, shown);
    }
    startLeft(place, shown);
}

// Where the left button does something else than set the cross-hair, a click still sets it.
void SliceHand::startLeft(const QPointF& place, const SliceRequest& shown) {
    drag_ = dragOfTool();
    if (drag_ != Drag::crosshair) return;
    const MouseDrag left = mouseProfile().leftOnSlices;
    if (left == MouseDrag::tool)
        parts_.travel.pointAt(shown.worldFromPane(place), shown.shows);
    else
        drag_ = dragOf(left);
}

SliceHand::Drag SliceHand::dragOf(MouseDrag drag) {
    switch (drag) {
        case MouseDrag::window:
            return Drag::window;
        case MouseDrag::pan:
            return Drag::pan;
        case MouseDrag::zoom:
            return Drag::zoom;
        case MouseDrag::scroll:
            return Drag::scroll;
        case MouseDrag::tool:
            break;
    }
    return Drag::none;
}

// Down as the wheel turns down.
void SliceHand::scrollTo(const QPointF& place) {
    scrollRestPx_ += place.y() - lastAt_.y();
    const int slices = int(scrollRestPx_ / kScrollPx);
    scrollRestPx_ -= slices * kScrollPx;
    if (slices != 0) parts_.travel.moveBy(-slices);
}

// Segments are drawn on the voxels of the study alone.
void SliceHand::pressBrush(const QPointF& place, const SliceRequest& shown) {
    const BrushTouch touch{shown.worldFromPane(place), shown.frame.plane.normal()};
    const bool isOfStudy = shown.showsStudy() && !shown.isOtherPhase;
    if (isOfStudy && brush_ != nullptr && brush_->press(touch)) drag_ = Drag::brush;
}

SliceHand::Drag SliceHand::dragOfTool() const {
    switch (tool_) {
        case SliceTool::crosshair:
            return Drag::crosshair;
        case SliceTool::window:
            return Drag::window;
        case SliceTool::zoom:
            return Drag::zoom;
        case SliceTool::pan:
            return Drag::pan;
        case SliceTool::probe:
            return Drag::probe;
        case SliceTool::curve:
            return Drag::curve;
        default:
            return measures(tool_) ? Drag::draw : Drag::none;
    }
}

bool SliceHand::takeClip(const QPointF& place, const SliceRequest& shown) {
    const auto clip = takesHold() ? parts_.clip.handleAt(place, shown) : std::nullopt;
    if (!clip) return false;
    parts_.clip.hold(clip->handle);
    drag_ = Drag::clip;
    parts_.session.endDrag();  // ends the undo step of an earlier drag
    return true;
}

bool SliceHand::takeMeasurement(const QPointF& place, const SliceRequest& shown) {
    const auto hit = takesHold() ? parts_.measurements.selectAt(place, shown) : std::nullopt;
    if (!hit) return false;
    if (hit->handle) {
        heldHandle_ = *hit->handle;
        drag_ = Drag::handle;
    }
    return true;
}

bool SliceHand::takeRing(const QPointF& place, const SliceRequest& shown) {
    if (tool_ != SliceTool::crosshair || !parts_.turn.hasRingAt(place, shown)) return false;
    parts_.turn.hold(place, shown);
    drag_ = Drag::turn;
    parts_.session.endDrag();
    return true;
}

bool SliceHand::selectAt(const QPointF& place, const SliceRequest& shown) {
    return takesHold() && parts_.measurements.selectAt(place, shown).has_value();
}

Qt::CursorShape SliceHand::usualCursor() const {
    return tool_ == SliceTool::pan ? Qt::OpenHandCursor : Qt::CrossCursor;
}

std::optional<Qt::CursorShape> SliceHand::cursorAt(const QPointF& place, const SliceRequest& shown) const {
    if (isHolding() || parts_.measurements.isDrawing()) return std::nullopt;
    if (parts_.clip.hasHandles() && takesHold()) {
        if (const auto handle = parts_.clip.handleAt(place, shown))
            return cursorOf(*handle, shown.frame.plane);
    }
    const bool isOnMark = (tool_ == SliceTool::crosshair && parts_.turn.hasRingAt(place, shown)) ||
                          (tool_ == SliceTool::curve && parts_.curve.hasPointAt(place, shown));
    return isOnMark ? Qt::PointingHandCursor : usualCursor();
}

void SliceHand::move(const Pointer& pointer, const SliceRequest& shown, const glm::ivec2& sizePx) {
    // The button went up elsewhere, without an event here.
    if (isHolding() && !pointer.buttons.testFlag(button_)) {
        if (drag_ == Drag::brush) brush_->release();
        drag_ = Drag::none;
        parts_.clip.letGo();
        parts_.turn.letGo();
        parts_.curve.letGo();
        parts_.session.endDrag();
    }
    dragTo(pointer, shown, sizePx);
    lastAt_ = pointer.place;
}

void SliceHand::dragTo(const Pointer& pointer, const SliceRequest& shown, const glm::ivec2& sizePx) {
    const QPointF& place = pointer.place;
    const QPointF by = place - lastAt_;
    const double heightPx = std::max(sizePx.y, 1);
    if (isStillClick(place)) return;
    hasDragged_ = hasDragged_ || isHolding();
    switch (drag_) {
        case Drag::crosshair:
            return parts_.travel.pointAt(shown.worldFromPane(place), shown.shows);
        case Drag::window:
            return parts_.windowing.drag(glm::dvec2(by.x(), by.y()) / heightPx);
        case Drag::zoom:
            return parts_.zoom.zoomAt(pressedAt_, std::pow(kDragZoomPerHeight, -by.y() / heightPx), sizePx);
        case Drag::pan:
            return parts_.zoom.panBy({by.x(), by.y()});
        case Drag::scroll:
            return scrollTo(place);
        case Drag::handle:
            return parts_.measurements.moveHandle(heldHandle_, shown.worldFromPane(place));
        case Drag::clip:
            return parts_.clip.dragTo(place, shown);
        case Drag::curve:
            return parts_.curve.dragTo(place, shown);
        case Drag::turn:
            return parts_.turn.dragTo(place, shown, pointer.modifiers.testFlag(Qt::ShiftModifier));
        case Drag::brush:
            return brush_->drag({shown.worldFromPane(place), shown.frame.plane.normal()});
        case Drag::draw:
        case Drag::none:
            return parts_.measurements.moveDrawing(shown.worldFromPane(place), drag_ == Drag::draw);
        case Drag::probe:
            return;
    }
}

// The pointer moves a little during a click.
bool SliceHand::isStillClick(const QPointF& place) const {
    const bool mayClick = drag_ == Drag::window || drag_ == Drag::zoom || drag_ == Drag::scroll;
    const bool isLeft = button_ == Qt::LeftButton && tool_ == SliceTool::crosshair;
    return (button_ == Qt::RightButton || isLeft) && mayClick && !hasDragged_ &&
           (place - pressedAt_).manhattanLength() <= kClickPx;
}

bool SliceHand::release(Qt::MouseButton button, const QPointF& place, const SliceRequest* shown) {
    if (!isHolding() || button != button_) return false;
    const Drag ended = std::exchange(drag_, Drag::none);
    parts_.clip.letGo();
    parts_.turn.letGo();
    parts_.curve.letGo();
    if (ended == Drag::brush) brush_->release();
    if (ended == Drag::draw && shown != nullptr)
        parts_.measurements.releaseDrawing(shown->worldFromPane(place));
    if (isUndoStep(ended)) parts_.session.endDrag();
    const bool isClick = button_ == Qt::LeftButton && !hasDragged_ && tool_ == SliceTool::crosshair &&
                         (ended == Drag::window || ended == Drag::scroll);
    if (isClick && shown != nullptr) parts_.travel.pointAt(shown->worldFromPane(place), shown->shows);
    if (isClick) parts_.session.endDrag();
    return button_ == Qt::RightButton && !hasDragged_;
}

void SliceHand::loseHandle() {
    if (drag_ == Drag::handle) drag_ = Drag::none;
}

void SliceHand::end() {
    if (isUndoStep(drag_)) parts_.session.endDrag();
    if (drag_ == Drag::brush) brush_->drop();
    drag_ = Drag::none;
    parts_.clip.letGo();
    parts_.turn.letGo();
    parts_.curve.letGo();
    parts_.measurements.dropDrawing();
}

}  // namespace macula::viewer
