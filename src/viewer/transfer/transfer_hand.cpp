#include "viewer/transfer/transfer_hand.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "scene/transfer/edited_transfer.h"

namespace macula::viewer {

namespace {

constexpr double kOctavePx = 100.0;     // a drag up by this length doubles the width
constexpr double kAngleOfHalf = 240.0;  // eighths of a degree of the wheel: two notches halve the range

constexpr double kOpacityPerKey = 0.01;
constexpr double kFactorPerKey = 1.02;
constexpr double kFiner = 0.1;
constexpr double kZoomPerKey = 1.25;

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

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

// The drag goes on with the new point until the button is released: all of it is undone as one step.
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

bool TransferKeys::isTaken(const QKeyEvent& event) {
    if (isArrow(event.key())) return true;
    if (event.modifiers().testFlag(Qt::ControlModifier)) return false;
    return event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace ||
           event.key() == Qt::Key_Insert || event.key() == Qt::Key_Plus || event.key() == Qt::Key_Minus ||
           event.key() == Qt::Key_Equal || event.key() == Qt::Key_0;
}

bool TransferKeys::press(const QKeyEvent& event) {
    const std::optional<PointId> selected = edits_.selected();
    const scene::ValueAxis& axis = plot_.axis();
    const double middle = selected ? plot_.valueOf(*selected) : 0.5 * (axis.shown.low + axis.shown.high);
    switch (event.key()) {
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return edits_.removeSelected(), true;
        case Qt::Key_Insert:
            return edits_.addBesideSelected(), true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return plot_.setAxis(axis.zoomed(1.0 / kZoomPerKey, middle)), true;
        case Qt::Key_Minus:
            return plot_.setAxis(axis.zoomed(kZoomPerKey, middle)), true;
        case Qt::Key_0:
            return plot_.fitAxis(), true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            return edits_.askForColour();
        case Qt::Key_Escape:
            if (!selected) return false;
            return edits_.select(std::nullopt), true;
        default:
            return nudge(event.key(), event.modifiers());
    }
}

void TransferKeys::release(const QKeyEvent& event) {
    if (isArrow(event.key()) && !event.isAutoRepeat()) end();
}

void TransferKeys::end() {
    if (std::exchange(isNudging_, false)) edits_.endDrag();
}

bool TransferKeys::nudge(int key, Qt::KeyboardModifiers modifiers) {
    if (!isArrow(key)) return false;
    const double times = modifiers.testFlag(Qt::ShiftModifier) ? kFiner : 1.0;
    const double right = key == Qt::Key_Right ? times : key == Qt::Key_Left ? -times : 0.0;
    const double up = key == Qt::Key_Up ? times : key == Qt::Key_Down ? -times : 0.0;
    isNudging_ = true;
    if (const auto selected = edits_.selected()) {
        nudgePoint(*selected, right, up);
    } else {
        nudgeWhole(right, up, modifiers.testFlag(Qt::ControlModifier));
    }
    return true;
}

void TransferKeys::nudgePoint(const PointId& point, double right, double up) {
    const TransferFunction& function = plot_.function();
    // Without a step sideways, exactly the same value.
    const auto moved = [&](double value) {
        return right == 0.0 ? value : value + right * plot_.keyStep() / plot_.map().scale;
    };
    if (point.curve == PointId::Curve::opacity) {
        const OpacityPoint& from = function.opacity[point.index];
        edits_.propose(scene::movedOpacityPoint(function, point.index, moved(from.value),
                                                from.opacity + up * kOpacityPerKey),
                       true);
    } else {
        edits_.propose(
            scene::movedColourPoint(function, point.index, moved(function.colour[point.index].value)), true);
    }
    if (const auto selected = edits_.selected()) plot_.reveal(*selected);
}

void TransferKeys::nudgeWhole(double right, double up, bool isScale) {
    const TransferFunction& function = plot_.function();
    const double factor = std::pow(kFactorPerKey, up);
    if (right != 0.0) {
        edits_.propose(scene::shifted(function, right * plot_.keyStep() / plot_.map().scale), true);
    } else if (isScale) {
        edits_.propose(scene::withOpacityScaled(function, factor), true);
    } else {
        const double middle = 0.5 * (function.opacity.front().value + function.opacity.back().value);
        edits_.propose(scene::widened(function, factor, middle), true);
    }
}

}  // namespace macula::viewer
