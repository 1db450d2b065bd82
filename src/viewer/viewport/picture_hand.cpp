#include "viewer/viewport/picture_hand.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

namespace macula::viewer {

namespace {

constexpr std::chrono::milliseconds kNudgeLasts{250};
constexpr double kDragZoomPerHeight = 6.0;  // times larger for a drag over the height of the picture

}  // namespace

void PictureTools::set(std::vector<PictureTool*> tools) {
    giveUp();
    std::erase(tools, nullptr);
    tools_ = std::move(tools);
}

bool PictureTools::wouldHold(const PicturePlace& place) const {
    return std::ranges::any_of(tools_, [&](PictureTool* tool) { return tool->point(place).has_value(); });
}

bool PictureTools::press(const PicturePlace& place) {
    const auto taker = std::ranges::find_if(tools_, [&](PictureTool* tool) { return tool->press(place); });
    if (taker == tools_.end()) return false;
    holder_ = *taker;
    return true;
}

void PictureTools::move(const PicturePlace& place) {
    if (holder_ != nullptr) holder_->move(place);
}

void PictureTools::release(const PicturePlace& place) {
    if (holder_ != nullptr) std::exchange(holder_, nullptr)->release(place);
}

void PictureTools::giveUp() {
    if (holder_ != nullptr) std::exchange(holder_, nullptr)->giveUp();
}

std::optional<Qt::CursorShape> PictureTools::cursorAt(const PicturePlace& place) const {
    std::optional<Qt::CursorShape> shape;
    for (PictureTool* tool : tools_) {
        if (!shape) shape = tool->point(place);
    }
    return shape;
}

bool PictureTools::turnWheel(double notches, const PictureGeometry& picture) const {
    return std::ranges::any_of(tools_, [&](PictureTool* tool) { return tool->turnWheel(notches, picture); });
}

std::vector<ToolMark> PictureTools::marks(const PictureGeometry& picture) const {
    std::vector<ToolMark> marks;
    for (const PictureTool* tool : tools_) std::ranges::copy(tool->marks(picture), std::back_inserter(marks));
    return marks;
}

PictureHand::PictureHand(const Parts& parts, Picture picture) : parts_(parts), picture_(std::move(picture)) {
    nudgeEnds_.setSingleShot(true);
    nudgeEnds_.setInterval(kNudgeLasts);
    connect(&nudgeEnds_, &QTimer::timeout, this, &PictureHand::rested);
    listen();
}

void PictureHand::listen() {
    VulkanWindow* window = &parts_.window;
    connect(window, &VulkanWindow::pointed, this, &PictureHand::point);
    connect(window, &VulkanWindow::dragBegan, this, [this] { isDragging_ = true; });
    connect(window, &VulkanWindow::dragged, this, &PictureHand::drag);
    connect(window, &VulkanWindow::dragEnded, this, [this] {
        parts_.tools.giveUp();
        isDragging_ = false;
        Q_EMIT rested();
    });
    window->setGrab([this](QPointF place, bool withShift) { return grab(place, withShift); });
    connect(window, &VulkanWindow::toolMoved, this,
            [this](QPointF place, bool withShift) { parts_.tools.move(placeAt(place, withShift)); });
    connect(window, &VulkanWindow::toolReleased, this,
            [this](QPointF place, bool withShift) { parts_.tools.release(placeAt(place, withShift)); });
    connect(window, &VulkanWindow::wheelTurned, this, &PictureHand::turnWheel);
    connect(window, &VulkanWindow::flyTurned, this, &PictureHand::fly);
}

PicturePlace PictureHand::placeAt(QPointF place, bool withShift) const {
    return {.picture = picture_.geometry(), .at = {place.x(), place.y()}, .withShift = withShift};
}

bool PictureHand::grab(QPointF place, bool withShift) {
    if (!picture_.hasStudy()) return false;
    const PicturePlace at = placeAt(place, withShift);
    // The picture on screen is about to be replaced: no tool takes hold, and the button does nothing.
    if (!picture_.isOnScreen()) return parts_.tools.wouldHold(at);
    if (!parts_.tools.press(at)) return false;
    isDragging_ = parts_.tools.changesPicture();
    return true;
}

void PictureHand::drag(VulkanWindow::Drag drag, QPointF byPixels) {
    const double height = parts_.window.height();
    switch (drag) {
        case VulkanWindow::Drag::tool:  // arrives as toolMoved
            return;
        case VulkanWindow::Drag::orbit:
            return parts_.camera.set(
                scene::orbitedByDrag(parts_.camera.now(), byPixels.x(), byPixels.y(), height));
        case VulkanWindow::Drag::pan:
            return parts_.camera.set(
                scene::pannedByDrag(parts_.camera.now(), byPixels.x(), byPixels.y(), height));
        case VulkanWindow::Drag::roll:
            return parts_.camera.set(scene::rolledByDrag(parts_.camera.now(), byPixels.x(), height));
        case VulkanWindow::Drag::transfer:
            if (!picture_.isProjection()) {
                Q_EMIT transferDragged(byPixels / std::max(height, 1.0));
                return;
            }
            [[fallthrough]];
        case VulkanWindow::Drag::windowOrZoom:
            if (picture_.isProjection()) {
                Q_EMIT windowDragged(byPixels / std::max(height, 1.0));
                return;
            }
            [[fallthrough]];
        case VulkanWindow::Drag::zoom:
            return parts_.camera.zoomBy(std::pow(kDragZoomPerHeight, -byPixels.y() / std::max(height, 1.0)));
    }
}

// The person looks where the pointer is. During a drag the point moves with the pointer.
void PictureHand::point(QPointF place) {
    pointedAt_ = {place.x(), place.y()};
    if (!picture_.hasStudy() || parts_.tools.isHolding()) return;
    if (const auto shape = parts_.tools.cursorAt(placeAt(place, false))) {
        parts_.window.setCursor(*shape);
    } else {
        parts_.window.unsetCursor();
    }
}

void PictureHand::turnWheel(double notches, bool withShift) {
    if (withShift && picture_.hasStudy() && parts_.tools.turnWheel(notches, picture_.geometry())) return;
    nudge();
    parts_.camera.zoomBy(std::pow(PictureCamera::kZoomPerNotch, notches));
}

void PictureHand::fly(double notches) {
    if (!picture_.hasStudy()) return;
    nudge();
    parts_.camera.flyBy(notches);
}

}  // namespace macula::viewer
