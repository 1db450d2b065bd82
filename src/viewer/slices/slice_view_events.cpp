// The events of a pane of slices, passed to its parts.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "viewer/slices/slice_view.h"

namespace macula::viewer {

// The tool tip is for screen readers only: on screen it would cover the picture wherever the pointer rests.
bool SliceView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    event->accept();  // nor the tool tip of a parent
    return true;
}

void SliceView::resizeEvent(QResizeEvent*) {
    request();
}

void SliceView::showEvent(QShowEvent*) {
    request();
}

void SliceView::hideEvent(QHideEvent*) {
    cine_.stop();
    endGesture();
    hoverAt_.reset();
}

void SliceView::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void SliceView::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

void SliceView::leaveEvent(QEvent*) {
    hoverAt_.reset();
    update();
}

void SliceView::mousePressEvent(QMouseEvent* event) {
    if (picture_.shown() == nullptr || hand_.isHolding()) return event->ignore();
    if (!hand_.press(event->button(), event->position(), *picture_.shownRequest())) return event->ignore();
    askForWords();
    update();
}

void SliceView::askForWords() {
    if (const auto arrow = measurements_.takeFinishedArrow()) popups_.editLabel(*arrow);
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
    hoverAt_ = event->position();
    const SliceRequest* shown = picture_.shownRequest();
    if (shown == nullptr) return;
    if (const auto cursor = hand_.cursorAt(event->position(), *shown)) setCursor(*cursor);
    hand_.move({event->position(), event->buttons(), event->modifiers()}, *shown, sizePx());
    update();
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
    const bool asksForMenu = hand_.release(event->button(), event->position(), picture_.shownRequest());
    askForWords();
    update();
    if (asksForMenu) popups_.openMenu(event->position());
}

// Drops the measurement that the first click began, which was not intended. During a drawing, and with a
// brush, a double-click is a click like any other.
void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::RightButton) {  // the first click opened no menu here
        hand_.drop();
        return fit();
    }
    if (event->button() != Qt::LeftButton || measurements_.isBeyondFirstPoint() ||
        hand_.tool() == SliceTool::segment || hand_.tool() == SliceTool::curve)
        return mousePressEvent(event);
    measurements_.dropDrawing();
    update();
    if (picture_.shown() != nullptr && hand_.selectAt(event->position(), *picture_.shownRequest())) {
        hand_.drop();
        return popups_.editLabel(*measurements_.selected());
    }
    Q_EMIT maximizeAsked();
}

void SliceView::wheelEvent(QWheelEvent* event) {
    event->accept();
    if (picture_.shown() == nullptr) return;
    const QPoint turned = event->angleDelta();
    const int by = turned.y() != 0 ? turned.y() : turned.x();
    if (event->modifiers().testFlag(Qt::ControlModifier))
        return zoom_.zoomAt(event->position(),
                            std::pow(PaneZoom::kPerNotch, double(by) / SliceTravel::kNotch), sizePx());
    travel_.turnWheel(by, event->modifiers().testFlag(Qt::ShiftModifier));
}

void SliceView::keyPressEvent(QKeyEvent* event) {
    if (keys_.press(*event, {.sizePx = sizePx(), .isVisible = isVisible(), .pointedAt = hoverAt_})) {
        update();
    } else {
        QWidget::keyPressEvent(event);
    }
}

}  // namespace macula::viewer
