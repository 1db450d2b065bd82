#include "viewer/clip/scissor_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/clip/scissor_cut.h"

namespace macula::viewer {

namespace {

constexpr double kLeastStepPx = 1.0;    // logical, as all below
constexpr double kLeastExtentPx = 6.0;  // a smaller outline was a click
constexpr double kOffPx = 0.5;          // how far the simplified outline may be from the drawn one
constexpr double kDotsEveryPx = 6.0;
constexpr std::size_t kMostPoints = 20000;
constexpr std::size_t kMostDots = 300;

double pixelsPerHalfHeight(const PictureGeometry& picture) {
    return 0.5 * picture.sizePx.y;
}

double extentOf(const std::vector<glm::dvec2>& points) {
    glm::dvec2 low = points.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return std::min(high.x - low.x, high.y - low.y);
}

}  // namespace

glm::dvec2 ScissorTool::halfHeights(const PicturePlace& place) {
    return {place.at.x * place.picture.aspect, place.at.y};
}

void ScissorTool::setOut(bool out) {
    if (std::exchange(isOut_, out) == out) return;
    giveUp();
    Q_EMIT taken(out);
}

bool ScissorTool::isOver(const PictureGeometry& picture) const {
    return outline_ && outline_->picture.camera == picture.camera &&
           outline_->picture.aspect == picture.aspect;
}

bool ScissorTool::press(const PicturePlace& place) {
    if (!isOut_) return false;
    outline_ = Outline{.picture = place.picture, .points = {halfHeights(place)}};
    Q_EMIT drawn();
    return true;
}

void ScissorTool::move(const PicturePlace& place) {
    if (!outline_) return;
    // In another picture the same outline would enclose something else.
    if (!isOver(place.picture)) return giveUp();
    const glm::dvec2 at = halfHeights(place);
    const double awayPx = glm::distance(outline_->points.back(), at) * pixelsPerHalfHeight(place.picture);
    if (!(awayPx >= kLeastStepPx) || outline_->points.size() >= kMostPoints) return;
    outline_->points.push_back(at);
    Q_EMIT drawn();
}

void ScissorTool::release(const PicturePlace& place) {
    move(place);
    if (!outline_) return;
    const Outline made = *std::exchange(outline_, std::nullopt);
    Q_EMIT drawn();
    const double scale = pixelsPerHalfHeight(made.picture);
    if (extentOf(made.points) * scale < kLeastExtentPx) return;
    const auto added = editing_.addScissorCut({.camera = made.picture.camera,
                                               .outline = scene::simplified(made.points, kOffPx / scale),
                                               .removesOutside = place.withShift});
    if (!added) Q_EMIT refused(added.error());
}

void ScissorTool::giveUp() {
    if (!outline_) return;
    outline_.reset();
    Q_EMIT drawn();
}

std::optional<Qt::CursorShape> ScissorTool::point(const PicturePlace&) {
    return isOut_ ? std::optional(Qt::CrossCursor) : std::nullopt;
}

// Dots along the drawn line, and half as many along the line that closes it.
std::vector<ToolMark> ScissorTool::marks(const PictureGeometry& picture) const {
    if (!isOver(picture)) return {};
    const auto place = [&](const glm::dvec2& p) { return glm::dvec2(p.x / picture.aspect, p.y); };
    double every = kDotsEveryPx / pixelsPerHalfHeight(picture);
    double length = 0.0;
    const std::vector<glm::dvec2>& points = outline_->points;
    for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
    every = std::max(every, length / double(kMostDots));
    std::vector<ToolMark> marks{{.kind = MarkKind::drawnDot, .place = place(points.front())}};
    double gone = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double step = glm::distance(points[i - 1], points[i]);
        for (; gone + step >= every; gone -= every) {
            const double share = (every - gone) / step;
            if (share > 1.0) break;
            marks.push_back({.kind = MarkKind::drawnDot,
                             .place = place(glm::mix(points[i - 1], points[i], std::max(share, 0.0)))});
        }
        gone += step;
    }
    const double closing = glm::distance(points.back(), points.front());
    for (double at = 2.0 * every; at < closing && marks.size() < kMostToolMarks; at += 2.0 * every)
        marks.push_back(
            {.kind = MarkKind::dot, .place = place(glm::mix(points.back(), points.front(), at / closing))});
    return marks;
}

}  // namespace macula::viewer
