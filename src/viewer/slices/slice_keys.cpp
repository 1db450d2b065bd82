#include "viewer/slices/slice_keys.h"

#include <QKeyEvent>

#include "viewer/keys/keys.h"

namespace macula::viewer {

bool SliceKeys::press(const QKeyEvent& event, const Pane& pane) {
    if (!parts_.content.hasStudy()) return false;
    const Qt::KeyboardModifiers others = event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    if (others == Qt::AltModifier && event.key() >= Qt::Key_1 && event.key() <= Qt::Key_9)
        return parts_.windowing.applyOwn(event.key() - Qt::Key_0), true;
    if (others == Qt::ControlModifier && (event.key() == Qt::Key_Left || event.key() == Qt::Key_Right))
        return turnPlanes(event.key() == Qt::Key_Right, event.modifiers().testFlag(Qt::ShiftModifier)), true;
    if (event.matches(QKeySequence::Copy)) return parts_.popups.copyPicture(), true;
    if (actionOf(event) == KeyAction::fit) return parts_.zoom.fit(), true;
    return others == Qt::NoModifier &&
           pressPlain(event.key(), event.modifiers().testFlag(Qt::ShiftModifier), pane);
}

void SliceKeys::turnPlanes(bool clockwise, bool byStep) {
    constexpr double kStepDeg = 15.0;
    const double deg = byStep ? kStepDeg : 1.0;
    const SliceSteps& steps = parts_.content.steps();
    parts_.turn.turnBy(clockwise ? deg : -deg,
                       steps.plane(parts_.content.slice(), parts_.content.crosshairMm()));
    parts_.session.endDrag();
}

bool SliceKeys::pressPlain(int key, bool withShift, const Pane& pane) {
    const QPointF middle(0.5 * pane.sizePx.x, 0.5 * pane.sizePx.y);
    const int slices = withShift ? SliceTravel::kManySlices : 1;
    switch (key) {
        case Qt::Key_Up:
            return parts_.travel.moveBy(slices), true;
        case Qt::Key_Down:
            return parts_.travel.moveBy(-slices), true;
        case Qt::Key_PageUp:
            return parts_.travel.moveBy(SliceTravel::kManySlices), true;
        case Qt::Key_PageDown:
            return parts_.travel.moveBy(-SliceTravel::kManySlices), true;
        case Qt::Key_Home:
            return parts_.travel.goToFirst(), true;
        case Qt::Key_End:
            return parts_.travel.goToLast(), true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:  // the same key without Shift on many keyboards
            return parts_.zoom.zoomAt(middle, PaneZoom::kPerNotch, pane.sizePx), true;
        case Qt::Key_Minus:
            return parts_.zoom.zoomAt(middle, 1.0 / PaneZoom::kPerNotch, pane.sizePx), true;
        case Qt::Key_Menu:
            return parts_.popups.openMenu(pane.pointedAt.value_or(middle)), true;
        case Qt::Key_I:
            parts_.session.change(tr("Inverted"), [](scene::StudyState& next) {
                next.slices.isInverted = !next.slices.isInverted;
            });
            return true;
        case Qt::Key_Space:
            if (parts_.content.role() == PaneRole::second) return false;  // this pane follows the study's
            if (parts_.cine.isOn()) return parts_.cine.stop(), true;
            if (pane.isVisible) parts_.cine.start();
            return true;
        default:
            if (key < Qt::Key_1 || key > Qt::Key_9) return pressOfMeasurements(key);
            return parts_.windowing.applyPreset(key - Qt::Key_0), true;
    }
}

bool SliceKeys::pressOfMeasurements(int key) {
    const auto selected = parts_.measurements.selected();
    switch (key) {
        case Qt::Key_Delete:
        case Qt::Key_Backspace:
            if (selected) return parts_.measurements.removeSelected(), true;
            return parts_.hand.tool() == SliceTool::curve && parts_.curve.removeLast();
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (selected) return parts_.popups.editLabel(*selected), true;
            if (parts_.hand.tool() != SliceTool::curve) return false;
            return parts_.curve.setPoint(parts_.content.crosshairMm()), true;
        case Qt::Key_Escape:
            return parts_.measurements.isDrawing() && (parts_.hand.end(), true);
        default:
            return false;
    }
}

}  // namespace macula::viewer
