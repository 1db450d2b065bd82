#include "viewer/transfer/transfer_keys.h"

#include <QKeyEvent>
#include <cmath>
#include <utility>

#include "scene/transfer/edited_transfer.h"

namespace macula::viewer {

namespace {

constexpr double kOpacityPerKey = 0.01;
constexpr double kFactorPerKey = 1.02;
constexpr double kFiner = 0.1;
constexpr double kZoomPerKey = 1.25;

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

}  // namespace

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
