#include "viewer/vulkan_window.h"

#include <QDropEvent>
#include <QExposeEvent>
#include <QMouseEvent>
#include <QPlatformSurfaceEvent>
#include <QVulkanInstance>
#include <QWheelEvent>
#include <algorithm>
#include <utility>

namespace macula::viewer {

namespace {

constexpr double kEighthsOfDegreePerNotch = 120.0;

}  // namespace

VulkanWindow::VulkanWindow(QVulkanInstance* instance) {
    setSurfaceType(QSurface::VulkanSurface);
    setVulkanInstance(instance);
}

VulkanWindow::~VulkanWindow() {
    loseSurface();
}

QSize VulkanWindow::pixels() const {
    return size() * devicePixelRatio();
}

void VulkanWindow::createSurface() {
    if (surface_ != VK_NULL_HANDLE) return;
    surface_ = QVulkanInstance::surfaceForWindow(this);  // Qt owns it and destroys it with the window
    if (surface_ == VK_NULL_HANDLE) {
        emit surfaceFailed();
    } else {
        emit surfaceReady();
    }
}

void VulkanWindow::loseSurface() {
    if (surface_ == VK_NULL_HANDLE) return;
    surface_ = VK_NULL_HANDLE;
    emit surfaceGoing();
}

bool VulkanWindow::event(QEvent* event) {
    switch (event->type()) {
        case QEvent::PlatformSurface: {
            const auto* surfaceEvent = static_cast<QPlatformSurfaceEvent*>(event);
            if (surfaceEvent->surfaceEventType() == QPlatformSurfaceEvent::SurfaceAboutToBeDestroyed) {
                loseSurface();
            }
            break;
        }
        case QEvent::DragEnter:
        case QEvent::DragMove:
            acceptDrop(*static_cast<QDropEvent*>(event));
            return true;
        case QEvent::Drop: {
            auto* drop = static_cast<QDropEvent*>(event);
            if (acceptDrop(*drop)) emit dropped(droppedBy(drop->mimeData()));
            return true;
        }
        default:
            break;
    }
    return QWindow::event(event);
}

void VulkanWindow::exposeEvent(QExposeEvent*) {
    if (!isExposed()) {
        emit hidden();
        return;
    }
    createSurface();
    emit exposed();
}

void VulkanWindow::resizeEvent(QResizeEvent*) {
    emit resized();
}

void VulkanWindow::mousePressEvent(QMouseEvent* event) {
    requestActivate();  // keys go to the picture that was clicked
    if (dragging_) return;
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    const bool control = event->modifiers().testFlag(Qt::ControlModifier);
    switch (event->button()) {
        case Qt::LeftButton:
            drag_ = shift ? Drag::pan : control ? Drag::zoom : Drag::orbit;
            break;
        case Qt::MiddleButton:
            drag_ = Drag::pan;
            break;
        case Qt::RightButton:
            drag_ = Drag::windowOrZoom;
            break;
        default:
            return;
    }
    last_ = event->position();
    if (event->button() == Qt::LeftButton && !control && grab_ && grab_(placeOf(last_), shift))
        drag_ = Drag::tool;
    dragging_ = true;
    dragButton_ = event->button();
    emit pointed(placeOf(last_));
    if (drag_ != Drag::tool) emit dragBegan();
}

void VulkanWindow::mouseMoveEvent(QMouseEvent* event) {
    if (!dragging_) {
        emit pointed(placeOf(event->position()));
        return;
    }
    // The button went up where this window was not told, as over a dialog.
    if (!event->buttons().testFlag(dragButton_)) return endDrag();
    if (drag_ == Drag::tool) {
        emit toolMoved(placeOf(event->position()), event->modifiers().testFlag(Qt::ShiftModifier));
        return;
    }
    const QPointF moved = event->position() - last_;
    last_ = event->position();
    emit dragged(drag_, moved);
}

QPointF VulkanWindow::placeOf(QPointF position) const {
    return {2.0 * position.x() / std::max(width(), 1) - 1.0,
            1.0 - 2.0 * position.y() / std::max(height(), 1)};
}

void VulkanWindow::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != dragButton_) return;
    if (dragging_ && drag_ == Drag::tool)
        emit toolReleased(placeOf(event->position()), event->modifiers().testFlag(Qt::ShiftModifier));
    endDrag();
}

void VulkanWindow::focusOutEvent(QFocusEvent*) {
    endDrag();
}

void VulkanWindow::endDrag() {
    if (!std::exchange(dragging_, false)) return;
    emit dragEnded();
}

void VulkanWindow::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) emit doubleClicked(placeOf(event->position()));
}

void VulkanWindow::wheelEvent(QWheelEvent* event) {
    // With some modifiers it turns sideways on some desktops.
    const QPoint turned = event->angleDelta();
    const int by = turned.y() != 0 ? turned.y() : turned.x();
    emit wheelTurned(by / kEighthsOfDegreePerNotch, event->modifiers().testFlag(Qt::ShiftModifier));
}

void VulkanWindow::keyPressEvent(QKeyEvent* event) {
    emit keyPressed(event);
}

}  // namespace macula::viewer
