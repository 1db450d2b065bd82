#include "viewer/transfer/transfer_hand.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "scene/transfer/edited_transfer.h"

namespace macula::viewer {

namespace {

constexpr double kOctavePx = 100.0;     // a drag up by this length doubles the width
constexpr double kAngleOfHalf = 240.0;  // eighths of a degree of the wheel: two notches halve the range

}  // namespace

void TransferHand::press(QMouseEvent& event) {
    const QPointF at = event.position();
    const std::optional<PointId> hit = plot_.pointAt(at);
    const bool isOverCurves = at.y() < plot_.layout().axis.top();
    const bool isAlt = event.modifiers().testFlag(Qt::AltModifier);
    if (isOverCurves &&
        (event.button() == Qt::RightButton || (event.button() == Qt::LeftButton && isAlt && !hit))) {
        begin(Held::whole, event);
    } else if (event.button() != Qt::LeftButton) {
        event.ignore();
    } else if (hit) {
        edits_.select(hit);
        beginPoint(*hit, event);
    } else if (isOverCurves) {
        edits_.select(std::nullopt);
    } else {
        begin(Held::axis, event);
    }
}

void TransferHand::begin(Held held, const QMouseEvent& event) {
    drag_ = Drag{.held = held,
                 .button = event.button(),
                 .from = event.position(),
                 .base = plot_.function(),
                 .axis = plot_.axis()};
}

void TransferHand::beginPoint(const PointId& point, const QMouseEvent& event) {
    begin(Held::point, event);
    drag_->point = point;
    drag_->grabbedAt = plot_.placeOf(point) - event.position();
}

void TransferHand::move(const QMouseEvent& event) {
    if (!drag_) return;
    const QPointF to = event.position();
    switch (drag_->held) {
        case Held::point:
            return dragPoint(to + drag_->grabbedAt);
        case Held::whole:
            return dragWhole(to, event.modifiers());
        case Held::axis:
            return plot_.setAxis(drag_->axis.panned((drag_->from.x() - to.x()) * drag_->axis.unitsPerPx()));
    }
}

void TransferHand::dragPoint(const QPointF& to) {
    const PointId point = drag_->point;
    const double value = plot_.presetValueAt(to.x());
    edits_.propose(point.curve == PointId::Curve::opacity
                       ? scene::movedOpacityPoint(drag_->base, point.index, value, plot_.opacityAt(to.y()))
                       : scene::movedColourPoint(drag_->base, point.index, value),
                   true);
}

void TransferHand::dragWhole(const QPointF& to, Qt::KeyboardModifiers modifiers) {
    const double factor = std::exp2((drag_->from.y() - to.y()) / kOctavePx);
    if (modifiers.testFlag(Qt::ControlModifier))
        return edits_.propose(scene::withOpacityScaled(drag_->base, factor), true);
    const double about = plot_.presetValueAt(drag_->from.x());
    edits_.propose(
        scene::shifted(scene::widened(drag_->base, factor, about), plot_.presetValueAt(to.x()) - about),
        true);
}

void TransferHand::release(const QMouseEvent& event) {
    if (!drag_ || event.button() != drag_->button) return;
    const Held held = drag_->held;
    drag_.reset();
    if (held != Held::axis) edits_.endDrag();
}

void TransferHand::doubleClick(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return;
    if (const std::optional<PointId> hit = plot_.pointAt(event.position())) {
        edits_.select(hit);
        edits_.askForColour();
    } else if (event.position().y() >= plot_.layout().axis.top()) {
        plot_.fitAxis();
    } else {
        addAt(event);
    }
}

// The drag goes on with the new point until the button is released: all of it is one step.
void TransferHand::addAt(const QMouseEvent& event) {
    const QPointF at = event.position();
    const TransferFunction& function = plot_.function();
    const double value = plot_.presetValueAt(at.x());
    const auto point =
        at.y() >= plot_.layout().strip.top()
            ? edits_.add(PointId::Curve::colour,
                         scene::withColourPoint(function, value, colourAt(function, value)), true)
            : edits_.add(PointId::Curve::opacity,
                         scene::withOpacityPoint(function, value, plot_.opacityAt(at.y())), true);
    if (point) beginPoint(*point, event);
}

void TransferHand::turnWheel(const QWheelEvent& event) {
    const QPoint angle = event.angleDelta();
    const double px = event.position().x() - plot_.layout().plot.left();
    if (angle.y() != 0)
        plot_.setAxis(plot_.axis().zoomed(std::exp2(-angle.y() / kAngleOfHalf), plot_.axis().valueAt(px)));
    if (angle.x() != 0) plot_.setAxis(plot_.axis().panned(-angle.x() * plot_.axis().unitsPerPx()));
}

}  // namespace macula::viewer
