// What the mouse does.
#include <QLineF>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "scene/transfer/edited_transfer.h"
#include "viewer/transfer/transfer_curve.h"

namespace macula::viewer {

namespace {

constexpr double kHitPx = 8.0;          // logical
constexpr double kOctavePx = 100.0;     // a drag up by so much makes twice as wide
constexpr double kAngleOfHalf = 240.0;  // of a wheel, in eighths of a degree: two steps halve the range

}  // namespace

// The nearest; of several at one place the last, which can be pulled off to the right.
std::optional<PointId> TransferCurve::pointAt(QPointF at) const {
    std::optional<PointId> nearest;
    double distance = kHitPx;
    const auto look = [&](const PointId& point) {
        const double away = QLineF(placeOf(point), at).length();
        if (away > distance) return;
        distance = away;
        nearest = point;
    };
    for (std::size_t i = 0; i < function_.opacity.size(); ++i) look({PointId::Curve::opacity, i});
    for (std::size_t i = 0; i < function_.colour.size(); ++i) look({PointId::Curve::colour, i});
    return nearest;
}

void TransferCurve::mousePressEvent(QMouseEvent* event) {
    if (drag_ || !hasFunction()) return;
    endNudge();
    const QPointF at = event->position();
    const std::optional<PointId> hit = pointAt(at);
    const bool isOverCurves = at.y() < axisRect().top();
    const bool isAlt = event->modifiers().testFlag(Qt::AltModifier);
    const Drag drag{.button = event->button(), .from = at, .base = function_, .axis = axis_};
    if (isOverCurves &&
        (event->button() == Qt::RightButton || (event->button() == Qt::LeftButton && isAlt && !hit))) {
        drag_ = drag;
        drag_->hand = Hand::whole;
    } else if (event->button() != Qt::LeftButton) {
        event->ignore();
    } else if (hit) {
        select(hit);
        beginPointDrag(*hit, *event);
    } else if (isOverCurves) {
        select(std::nullopt);
    } else {
        drag_ = drag;
        drag_->hand = Hand::axis;
    }
}

void TransferCurve::beginPointDrag(const PointId& point, const QMouseEvent& event) {
    drag_ = Drag{.hand = Hand::point,
                 .button = event.button(),
                 .from = event.position(),
                 .base = function_,
                 .axis = axis_,
                 .point = point,
                 .grabbedAt = placeOf(point) - event.position()};
}

void TransferCurve::mouseMoveEvent(QMouseEvent* event) {
    if (!drag_) return;
    const QPointF to = event->position();
    switch (drag_->hand) {
        case Hand::point:
            dragPoint(to + drag_->grabbedAt);
            break;
        case Hand::whole:
            dragWhole(to, event->modifiers());
            break;
        case Hand::axis:
            setAxis(drag_->axis.panned((drag_->from.x() - to.x()) * drag_->axis.unitsPerPx()), false);
            break;
    }
}

void TransferCurve::dragPoint(QPointF to) {
    const PointId point = drag_->point;
    const double value = presetValueAt(to.x());
    propose(point.curve == PointId::Curve::opacity
                ? scene::movedOpacityPoint(drag_->base, point.index, value, opacityAtPx(to.y()))
                : scene::movedColourPoint(drag_->base, point.index, value),
            true);
}

void TransferCurve::dragWhole(QPointF to, Qt::KeyboardModifiers modifiers) {
    const double factor = std::exp2((drag_->from.y() - to.y()) / kOctavePx);
    if (modifiers.testFlag(Qt::ControlModifier)) {
        propose(scene::withOpacityScaled(drag_->base, factor), true);
        return;
    }
    const double about = presetValueAt(drag_->from.x());
    propose(scene::shifted(scene::widened(drag_->base, factor, about), presetValueAt(to.x()) - about), true);
}

void TransferCurve::mouseReleaseEvent(QMouseEvent* event) {
    if (!drag_ || event->button() != drag_->button) return;
    const Hand hand = drag_->hand;
    drag_.reset();
    if (hand != Hand::axis) emit dragEnded();
}

void TransferCurve::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || drag_ || !hasFunction()) return;
    if (const std::optional<PointId> hit = pointAt(event->position())) {
        select(hit);
        if (hit->curve == PointId::Curve::colour) emit colourAsked();
    } else if (event->position().y() >= axisRect().top()) {
        fitAxis();
    } else {
        addAt(*event);
    }
}

// It stays under the hand until the button is let go: all of it is one step.
void TransferCurve::addAt(const QMouseEvent& event) {
    const QPointF at = event.position();
    const double value = presetValueAt(at.x());
    const bool isColour = at.y() >= stripRect().top();
    const scene::Added added = isColour ? scene::withColourPoint(function_, value, colourAt(function_, value))
                                        : scene::withOpacityPoint(function_, value, opacityAtPx(at.y()));
    if (!added.index) return;
    propose(added.function, true);
    if (!(function_ == added.function)) return;  // nobody wanted it
    const PointId point{isColour ? PointId::Curve::colour : PointId::Curve::opacity, *added.index};
    select(point);
    beginPointDrag(point, event);
}

void TransferCurve::wheelEvent(QWheelEvent* event) {
    event->accept();
    if (!hasFunction() || drag_) return;
    const QPoint angle = event->angleDelta();
    const double px = event->position().x() - plotRect().left();
    if (angle.y() != 0) setAxis(axis_.zoomed(std::exp2(-angle.y() / kAngleOfHalf), axis_.valueAt(px)), false);
    if (angle.x() != 0) setAxis(axis_.panned(-angle.x() * axis_.unitsPerPx()), false);
}

}  // namespace macula::viewer
