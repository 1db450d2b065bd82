// What hands do in the picture: keys, drags, the wheel, and the tools that may take them.
#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "viewer/keys/focus_order.h"
#include "viewer/keys/keys.h"

namespace macula::viewer {

namespace {

constexpr double kOrbitStepDeg = 5.0;
constexpr double kPanStepOfHeight = 0.05;
constexpr double kZoomPerNotch = 1.15;
constexpr double kDragZoomPerHeight = 6.0;  // times larger for a drag over the height of the picture
constexpr double kRollStepDeg = 5.0;
constexpr double kFlyOfDiagonal = 0.03;  // for each notch

// Steps to the right and down.
std::optional<QPointF> arrowOfKey(int key) {
    switch (key) {
        case Qt::Key_Left:
            return QPointF(-1, 0);
        case Qt::Key_Right:
            return QPointF(1, 0);
        case Qt::Key_Up:
            return QPointF(0, -1);
        case Qt::Key_Down:
            return QPointF(0, 1);
        default:
            return std::nullopt;
    }
}

}  // namespace

// The cube on screen is that of the picture, not of the camera that is asked for by now.
std::optional<ViewDirection> Viewport::sideAt(QPointF place) const {
    const auto picture = marksShown_ ? pictureOnScreen() : std::nullopt;
    return picture ? cubeSideAt(*picture, place) : std::nullopt;
}

void Viewport::turnToSide(QPointF place) {
    if (const auto side = sideAt(place)) setCamera(scene::turnedTo(camera_, *side));
}

// With parallel rays nothing comes nearer: what is seen gets larger instead.
void Viewport::fly(double notches) {
    if (!input_.volume) return;
    nudge();
    if (camera_.isParallel)
        return setCamera(zoomed(camera_, std::pow(kZoomPerNotch, notches), sceneDiagonalMm()));
    setCamera(flown(camera_, notches * kFlyOfDiagonal * sceneDiagonalMm(), input_.volume->worldBox()));
}

bool Viewport::handleRoll(const QKeyEvent& event) {
    const bool control = event.modifiers().testFlag(Qt::ControlModifier);
    const auto is = [&](Qt::Key bracket, Qt::Key arrow) {
        // Many keyboards have brackets with AltGr only, which some platforms tell as Ctrl and Alt.
        return event.key() == bracket || (control && event.key() == arrow);
    };
    const bool clockwise = is(Qt::Key_BracketRight, Qt::Key_Right);
    if (!clockwise && !is(Qt::Key_BracketLeft, Qt::Key_Left)) return false;
    nudge();
    setCamera(rolled(camera_, clockwise ? kRollStepDeg : -kRollStepDeg));
    return true;
}

// Keys of a native window pass no widget that would know where Tab goes.
bool Viewport::moveFocus(const QKeyEvent& event) {
    const bool isBack = event.key() == Qt::Key_Backtab ||
                        (event.key() == Qt::Key_Tab && event.modifiers().testFlag(Qt::ShiftModifier));
    if (!isBack && event.key() != Qt::Key_Tab) return false;
    if ((event.modifiers() & ~Qt::ShiftModifier) != Qt::NoModifier) return false;
    QWidget* next = nextInTabOrder(*container_, !isBack);
    if (next == nullptr) return true;
    QWidget::window()
        ->activateWindow();  // keys go on to the native window until its parent is the active one
    next->setFocus(isBack ? Qt::BacktabFocusReason : Qt::TabFocusReason);
    return true;
}

bool Viewport::handleKey(const QKeyEvent& event) {
    if (handleRoll(event)) return true;
    const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
    const Qt::KeyboardModifiers others = event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    if (others != Qt::NoModifier) return false;
    if (const auto arrow = arrowOfKey(event.key())) {
        nudge();
        if (shift) {
            setCamera(scene::pannedByDrag(camera_, arrow->x() * kPanStepOfHeight,
                                          arrow->y() * kPanStepOfHeight, 1));
        } else {
            // The eye goes where the arrow points.
            setCamera(orbited(camera_, arrow->x() * kOrbitStepDeg, -arrow->y() * kOrbitStepDeg));
        }
        return true;
    }
    const std::optional<KeyAction> action = actionOf(event);
    if (action == KeyAction::fit) return fit(), true;
    if (action == KeyAction::names) return showNames(!namesShown_), true;
    if (action == KeyAction::marks) return emit marksAsked(!marksShown_), true;
    if (action == KeyAction::parallel) return setParallel(!camera_.isParallel), true;
    if (const auto view = action ? viewDirectionOf(*action) : std::nullopt) return showFrom(*view), true;
    switch (event.key()) {
        case Qt::Key_Escape:
            if (holder_ == nullptr) return false;
            return endHold(), true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:  // the same key without shift on many keyboards
            nudge();
            setCamera(zoomed(camera_, kZoomPerNotch, sceneDiagonalMm()));
            return true;
        case Qt::Key_Minus:
            nudge();
            setCamera(zoomed(camera_, 1.0 / kZoomPerNotch, sceneDiagonalMm()));
            return true;
        default:
            return false;
    }
}

void Viewport::applyDrag(VulkanWindow::Drag drag, QPointF byPixels) {
    const double height = window_->height();
    switch (drag) {
        case VulkanWindow::Drag::tool:  // is told as toolMoved
            return;
        case VulkanWindow::Drag::orbit:
            return setCamera(scene::orbitedByDrag(camera_, byPixels.x(), byPixels.y(), height));
        case VulkanWindow::Drag::pan:
            return setCamera(scene::pannedByDrag(camera_, byPixels.x(), byPixels.y(), height));
        case VulkanWindow::Drag::roll:
            return setCamera(scene::rolledByDrag(camera_, byPixels.x(), height));
        case VulkanWindow::Drag::transfer:
            if (!trace::isProjection(input_.drawing.settings.look)) {
                emit transferDragged(byPixels / std::max(height, 1.0));
                return;
            }
            [[fallthrough]];
        case VulkanWindow::Drag::windowOrZoom:
            if (trace::isProjection(input_.drawing.settings.look)) {
                emit windowDragged(byPixels / std::max(height, 1.0));
                return;
            }
            [[fallthrough]];
        case VulkanWindow::Drag::zoom:
            return setCamera(zoomed(camera_,
                                    std::pow(kDragZoomPerHeight, -byPixels.y() / std::max(height, 1.0)),
                                    sceneDiagonalMm()));
    }
}

void Viewport::setTools(std::vector<PictureTool*> tools) {
    endHold();
    std::erase(tools, nullptr);
    tools_ = std::move(tools);
    updateToolMarks();
}

void Viewport::updateToolMarks() {
    const auto before = input_.marks;
    updateMarks();
    if (input_.marks != before) publish();
}

PictureGeometry Viewport::geometry() const {
    return {.camera = toCamera(camera_),
            .aspect = aspect(),
            .sizePx = {std::max(window_->width(), 1), std::max(window_->height(), 1)}};
}

PicturePlace Viewport::placeAt(QPointF place, bool withShift) const {
    return {.picture = geometry(), .at = {place.x(), place.y()}, .withShift = withShift};
}

bool Viewport::grab(QPointF place, bool withShift) {
    if (!input_.volume) return false;
    const PicturePlace at = placeAt(place, withShift);
    // Of a picture that will be gone in a moment no tool takes hold, and the button does nothing.
    if (!isCameraOnScreen())
        return std::ranges::any_of(tools_, [&](PictureTool* tool) { return tool->point(at).has_value(); });
    const auto taker = std::ranges::find_if(tools_, [&](PictureTool* tool) { return tool->press(at); });
    if (taker == tools_.end()) return false;
    holder_ = *taker;
    dragging_ = holder_->changesPicture();
    return true;
}

// What is pointed at is what is looked at; while it is dragged it goes with the pointer.
void Viewport::onPointed(QPointF place) {
    pointedAt_ = {place.x(), place.y()};
    if (!input_.volume || holder_ != nullptr) return;
    std::optional<Qt::CursorShape> shape;
    for (PictureTool* tool : tools_) {
        if (!shape) shape = tool->point(placeAt(place, false));
    }
    if (shape) {
        window_->setCursor(*shape);
    } else {
        window_->unsetCursor();
    }
}

void Viewport::endHold() {
    if (holder_ != nullptr) std::exchange(holder_, nullptr)->giveUp();
}

void Viewport::onWheel(double notches, bool withShift) {
    const auto isForTool = [&](PictureTool* tool) { return tool->turnWheel(notches, geometry()); };
    if (withShift && input_.volume && std::ranges::any_of(tools_, isForTool)) return;
    nudge();
    setCamera(zoomed(camera_, std::pow(kZoomPerNotch, notches), sceneDiagonalMm()));
}

void Viewport::nudge() {
    nudgeEnds_.start();
}

}  // namespace macula::viewer
