#include "viewer/viewport/vulkan_window.h"

#include <QDropEvent>
#include <QExposeEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPlatformSurfaceEvent>
#include <QSplitter>
#include <QTimer>
#include <QVBoxLayout>
#include <QVulkanInstance>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <string>
#include <utility>

#include "viewer/keys/focus_order.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr double kEighthsOfDegreePerNotch = 120.0;
constexpr double kClickPx = 3.0;  // the pointer moves this much during a click
constexpr Qt::Key kTransferKey = Qt::Key_T;

constexpr QSize kSmallestPicture{160, 120};

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
        Q_EMIT surfaceFailed();
    } else {
        Q_EMIT surfaceReady();
    }
}

void VulkanWindow::loseSurface() {
    if (surface_ == VK_NULL_HANDLE) return;
    surface_ = VK_NULL_HANDLE;
    Q_EMIT surfaceGoing();
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
            if (acceptDrop(*drop)) Q_EMIT dropped(droppedBy(drop->mimeData()));
            return true;
        }
        default:
            break;
    }
    return QWindow::event(event);
}

void VulkanWindow::exposeEvent(QExposeEvent*) {
    if (!isExposed()) {
        Q_EMIT hidden();
        return;
    }
    createSurface();
    Q_EMIT exposed();
}

void VulkanWindow::resizeEvent(QResizeEvent*) {
    Q_EMIT resized();
}

void VulkanWindow::mousePressEvent(QMouseEvent* event) {
    requestActivate();  // keys go to the picture that was clicked
    if (dragging_) return;
    const std::optional<Drag> drag = dragOf(*event);
    if (!drag) return;
    drag_ = *drag;
    last_ = pressedAt_ = event->position();
    // With Ctrl, Alt or kTransferKey, the left button moves the camera or edits the transfer function.
    const bool isForTools = event->button() == Qt::LeftButton && (drag_ == Drag::orbit || drag_ == Drag::pan);
    if (isForTools && grab_ && grab_(placeOf(last_), event->modifiers().testFlag(Qt::ShiftModifier)))
        drag_ = Drag::tool;
    dragging_ = true;
    hasMoved_ = false;
    dragButton_ = event->button();
    Q_EMIT pointed(placeOf(last_));
    if (drag_ != Drag::tool) Q_EMIT dragBegan();
}

std::optional<VulkanWindow::Drag> VulkanWindow::dragOf(const QMouseEvent& event) const {
    const bool alt = event.modifiers().testFlag(Qt::AltModifier);
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    const bool control = event.modifiers().testFlag(Qt::ControlModifier);
    switch (event.button()) {
        case Qt::LeftButton:
            return holdsTransfer_ ? Drag::transfer
                   : alt          ? Drag::roll
                   : shift        ? Drag::pan
                   : control      ? Drag::zoom
                                  : Drag::orbit;
        case Qt::MiddleButton:
            return Drag::pan;
        case Qt::RightButton:
            return holdsTransfer_ || alt ? Drag::transfer : Drag::windowOrZoom;
        default:
            return std::nullopt;
    }
}

void VulkanWindow::mouseMoveEvent(QMouseEvent* event) {
    if (!dragging_) {
        Q_EMIT pointed(placeOf(event->position()));
        return;
    }
    // The button went up without an event here, for example over a dialog.
    if (!event->buttons().testFlag(dragButton_)) return endDrag();
    if (drag_ == Drag::tool) {
        Q_EMIT toolMoved(placeOf(event->position()), event->modifiers().testFlag(Qt::ShiftModifier));
        return;
    }
    const QPointF moved = event->position() - last_;
    last_ = event->position();
    hasMoved_ = hasMoved_ || (last_ - pressedAt_).manhattanLength() > kClickPx;
    Q_EMIT dragged(drag_, moved);
}

QPointF VulkanWindow::placeOf(QPointF position) const {
    return {2.0 * position.x() / std::max(width(), 1) - 1.0,
            1.0 - 2.0 * position.y() / std::max(height(), 1)};
}

void VulkanWindow::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != dragButton_) return;
    const bool isClick = dragging_ && !hasMoved_ && drag_ == Drag::orbit;
    if (dragging_ && drag_ == Drag::tool)
        Q_EMIT toolReleased(placeOf(event->position()), event->modifiers().testFlag(Qt::ShiftModifier));
    endDrag();
    if (isClick) Q_EMIT clicked(placeOf(event->position()));
}

void VulkanWindow::focusOutEvent(QFocusEvent*) {
    holdsTransfer_ = false;  // the window gets no event of keys released elsewhere
    endDrag();
}

void VulkanWindow::endDrag() {
    if (!std::exchange(dragging_, false)) return;
    Q_EMIT dragEnded();
}

void VulkanWindow::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) Q_EMIT doubleClicked(placeOf(event->position()));
}

void VulkanWindow::wheelEvent(QWheelEvent* event) {
    // With some modifiers a wheel reports sideways turns: with Alt on most platforms, with Shift on some.
    const QPoint angle = event->angleDelta();
    const double notches = (angle.y() != 0 ? angle.y() : angle.x()) / kEighthsOfDegreePerNotch;
    if (event->modifiers().testFlag(Qt::AltModifier)) {
        Q_EMIT flyTurned(notches);
    } else {
        Q_EMIT wheelTurned(notches, event->modifiers().testFlag(Qt::ShiftModifier));
    }
}

void VulkanWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() == kTransferKey && event->modifiers() == Qt::NoModifier) holdsTransfer_ = true;
    Q_EMIT keyPressed(event);
}

void VulkanWindow::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == kTransferKey && !event->isAutoRepeat()) holdsTransfer_ = false;
}

WindowContainer::WindowContainer(QWindow& window, QWidget& parent)
    : parent_(parent), widget_(QWidget::createWindowContainer(&window, &parent)) {
    widget_->setFocusPolicy(Qt::StrongFocus);
    describe(*widget_, "volume", tr("The volume in 3D"),
             tr("Left drag or arrows walk around the patient, the wheel goes closer; sizes are in mm"));
    widget_->setMinimumSize(kSmallestPicture);
    QSizePolicy policy = widget_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget_->setSizePolicy(policy);
    parent.setFocusProxy(widget_.get());
    auto* column = new QVBoxLayout(&parent);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(widget_.get());
}

void WindowContainer::setSizeHint(const QSize& devicePixels) {
    widget_->setMinimumSize(devicePixels / parent_.devicePixelRatioF());
    // Until the window is shown, Qt invalidates only the layout that holds the widget, and none above it.
    for (QWidget* above = &parent_; above != nullptr; above = above->parentWidget()) {
        if (above->layout() != nullptr) above->layout()->invalidate();
        if (auto* splitter = qobject_cast<QSplitter*>(above)) splitter->refresh();
        above->updateGeometry();
    }
    // Once the window has taken it over, the user may make it smaller again.
    QTimer::singleShot(0, widget_.get(),
                       [widget = widget_.get()] { widget->setMinimumSize(kSmallestPicture); });
}

bool WindowContainer::moveFocus(const QKeyEvent& event) {
    const bool isBack = event.key() == Qt::Key_Backtab ||
                        (event.key() == Qt::Key_Tab && event.modifiers().testFlag(Qt::ShiftModifier));
    if (!isBack && event.key() != Qt::Key_Tab) return false;
    if ((event.modifiers() & ~Qt::ShiftModifier) != Qt::NoModifier) return false;
    QWidget* next = nextInTabOrder(*widget_, !isBack);
    if (next == nullptr) return true;
    // The native window keeps getting the keys until its parent is the active window.
    parent_.window()->activateWindow();
    next->setFocus(isBack ? Qt::BacktabFocusReason : Qt::TabFocusReason);
    return true;
}

void WindowContainer::describeSides(const scene::EdgeLetters& letters) {
    const auto side = [](const std::string& text) { return QString::fromStdString(text); };
    widget_->setAccessibleDescription(
        letters.left.empty()
            ? QString()
            : tr("Sides of the patient at the left, right, top and bottom: %1, %2, %3, %4")
                  .arg(side(letters.left), side(letters.right), side(letters.top), side(letters.bottom)));
}

}  // namespace macula::viewer
