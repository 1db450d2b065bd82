// What keys do.
#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/transfer/edited_transfer.h"
#include "viewer/transfer/transfer_curve.h"

namespace macula::viewer {

namespace {

constexpr double kOpacityPerKey = 0.01;
constexpr double kFactorPerKey = 1.02;
constexpr double kFiner = 0.1;
constexpr double kZoomPerKey = 1.25;

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

// Keys that a window may have a shortcut for; here they are for the points.
bool isTaken(const QKeyEvent& event) {
    if (isArrow(event.key())) return true;
    if (event.modifiers().testFlag(Qt::ControlModifier)) return false;
    return event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace ||
           event.key() == Qt::Key_Insert || event.key() == Qt::Key_Plus || event.key() == Qt::Key_Minus ||
           event.key() == Qt::Key_Equal || event.key() == Qt::Key_0;
}

}  // namespace

bool TransferCurve::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && hasFunction() &&
        isTaken(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void TransferCurve::keyPressEvent(QKeyEvent* event) {
    if (!hasFunction() || drag_) return QWidget::keyPressEvent(event);
    const double middle = selected_ ? valueOf(*selected_) : 0.5 * (axis_.shown.low + axis_.shown.high);
    switch (event->key()) {
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            return removeSelected();
        case Qt::Key_Insert:
            return addSecondSelected();
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return setAxis(axis_.zoomed(1.0 / kZoomPerKey, middle), false);
        case Qt::Key_Minus:
            return setAxis(axis_.zoomed(kZoomPerKey, middle), false);
        case Qt::Key_0:
            return fitAxis();
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            if (!selected_ || selected_->curve != PointId::Curve::colour) break;
            emit colourAsked();
            return;
        case Qt::Key_Escape:
            if (!selected_) break;
            return select(std::nullopt);
        default:
            if (nudge(event->key(), event->modifiers())) return;
    }
    QWidget::keyPressEvent(event);
}

void TransferCurve::keyReleaseEvent(QKeyEvent* event) {
    if (isArrow(event->key()) && !event->isAutoRepeat()) endNudge();
    QWidget::keyReleaseEvent(event);
}

void TransferCurve::focusOutEvent(QFocusEvent* event) {
    endNudge();
    QWidget::focusOutEvent(event);
    update();
}

void TransferCurve::endNudge() {
    if (!std::exchange(isNudging_, false)) return;
    emit dragEnded();
}

bool TransferCurve::nudge(int key, Qt::KeyboardModifiers modifiers) {
    if (!isArrow(key)) return false;
    const double right = key == Qt::Key_Right ? 1.0 : key == Qt::Key_Left ? -1.0 : 0.0;
    const double up = key == Qt::Key_Up ? 1.0 : key == Qt::Key_Down ? -1.0 : 0.0;
    const bool isFine = modifiers.testFlag(Qt::ShiftModifier);
    isNudging_ = true;
    if (selected_) {
        nudgePoint(right, up, isFine);
    } else {
        nudgeWhole(right, up, isFine, modifiers.testFlag(Qt::ControlModifier));
    }
    return true;
}

void TransferCurve::nudgePoint(double right, double up, bool isFine) {
    const PointId point = *selected_;
    const double times = isFine ? kFiner : 1.0;
    // Without a step sideways, to the bit where it was.
    const auto moved = [&](double value) {
        return right == 0.0 ? value : value + right * times * keyStep() / map_.scale;
    };
    if (point.curve == PointId::Curve::opacity) {
        const OpacityPoint& from = function_.opacity[point.index];
        propose(scene::movedOpacityPoint(function_, point.index, moved(from.value),
                                         from.opacity + up * times * kOpacityPerKey),
                true);
    } else {
        propose(scene::movedColourPoint(function_, point.index, moved(function_.colour[point.index].value)),
                true);
    }
    if (selected_) reveal(*selected_);
}

void TransferCurve::nudgeWhole(double right, double up, bool isFine, bool isScale) {
    const double times = isFine ? kFiner : 1.0;
    const double factor = std::pow(kFactorPerKey, up * times);
    if (right != 0.0) {
        propose(scene::shifted(function_, right * times * keyStep() / map_.scale), true);
    } else if (isScale) {
        propose(scene::withOpacityScaled(function_, factor), true);
    } else {
        const double middle = 0.5 * (function_.opacity.front().value + function_.opacity.back().value);
        propose(scene::widened(function_, factor, middle), true);
    }
}

// Halfway to the next point, or to the end of the axis.
void TransferCurve::addSecondSelected() {
    const PointId from = selected_.value_or(PointId{});
    const bool isColour = from.curve == PointId::Curve::colour;
    const std::size_t count = isColour ? function_.colour.size() : function_.opacity.size();
    const double low = selected_ ? valueOf(from) : axis_.shown.low;
    const bool hasNext = selected_ && from.index + 1 < count;
    const double high = hasNext ? valueOf({from.curve, from.index + 1}) : std::max(low, axis_.shown.high);
    const double value = map_.presetFrom(0.5 * (low + high));
    const scene::Added added = isColour
                                   ? scene::withColourPoint(function_, value, colourAt(function_, value))
                                   : scene::withOpacityPoint(function_, value, opacityAt(function_, value));
    if (!added.index) return;
    propose(added.function, false);
    if (!(function_ == added.function)) return;
    select(PointId{from.curve, *added.index});
    reveal(*selected_);
}

void TransferCurve::removeSelected() {
    if (!selected_) return;
    const PointId point = *selected_;
    const bool isColour = point.curve == PointId::Curve::colour;
    TransferFunction left = isColour ? scene::withoutColourPoint(function_, point.index)
                                     : scene::withoutOpacityPoint(function_, point.index);
    if (left == function_) return;  // the last of its curve
    propose(left, false);
    if (!(function_ == left)) return;
    // The one that has taken its place, so that several can be removed in a row.
    const std::size_t count = isColour ? left.colour.size() : left.opacity.size();
    selected_.reset();
    select(PointId{point.curve, std::min(point.index, count - 1)});
}

bool TransferCurve::focusNextPrevChild(bool next) {
    const std::size_t opacities = function_.opacity.size();
    if (!hasFunction() || !isEnabled()) return QWidget::focusNextPrevChild(next);
    std::optional<std::size_t> place;  // those of opacity, then those of colour
    if (!selected_) {
        place = next ? 0 : pointCount() - 1;
    } else {
        const std::size_t now =
            selected_->curve == PointId::Curve::opacity ? selected_->index : opacities + selected_->index;
        if (next && now + 1 < pointCount()) place = now + 1;
        if (!next && now > 0) place = now - 1;
    }
    endNudge();
    if (!place) {
        select(std::nullopt);
        return QWidget::focusNextPrevChild(next);
    }
    const bool isColour = *place >= opacities;
    select(isColour ? PointId{PointId::Curve::colour, *place - opacities}
                    : PointId{PointId::Curve::opacity, *place});
    reveal(*selected_);
    return true;
}

}  // namespace macula::viewer
