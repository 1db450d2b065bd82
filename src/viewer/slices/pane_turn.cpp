#include "viewer/slices/pane_turn.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "viewer/overlay/haloed_drawing.h"
#include "viewer/overlay/slice_texts.h"

namespace macula::viewer {

namespace {

constexpr double kRingPx = 5.0;
constexpr double kReachPx = 10.0;      // of a ring
constexpr double kNearestPx = 45.0;    // of a ring to the cross-hair
constexpr double kAlong = 0.75;        // of the way to the pane's edge
constexpr double kSmallestPx = 120.0;  // a smaller pane has no rings
constexpr double kCatchDeg = 1.5;
constexpr double kStepDeg = 15.0;
constexpr double kStraight = 1.0 - 1e-10;  // the cosine of half of the least turn

// The direction in which another plane cuts this one, in the picture.
glm::dvec2 lineOf(const slices::SlicePlane& plane, const glm::dvec3& otherNormal, const glm::dvec2& usual) {
    const glm::dvec3 along = glm::cross(plane.normal(), otherNormal);
    glm::dvec2 line(glm::dot(along, plane.right), glm::dot(along, plane.down));
    const double length = glm::length(line);
    if (!(length > 1e-9)) return usual;
    line /= length;
    return glm::dot(line, usual) < 0.0 ? -line : line;
}

// From upright, clockwise in the picture, -90 to 90.
double turnDegOf(const glm::dvec2& vertical) {
    return glm::degrees(std::atan2(-vertical.x, vertical.y));
}

double angleOf(const QPointF& from, const QPointF& to) {
    return std::atan2(to.y() - from.y(), to.x() - from.x());
}

}  // namespace

PaneTurn::PaneTurn(StudyEditor& session, const PaneContent& content) : session_(session), content_(content) {}

CrosshairLines PaneTurn::linesOn(const slices::SlicePlane& plane) const {
    CrosshairLines lines;
    const slices::Orientation pane = content_.orientation();
    lines.vertical = lineOf(plane, content_.normalOf(verticalOf(pane)), lines.vertical);
    lines.horizontal = lineOf(plane, content_.normalOf(horizontalOf(pane)), lines.horizontal);
    return lines;
}

QPointF PaneTurn::crosshairOn(const SliceRequest& shown) const {
    const glm::dvec2 px = shown.frame.pictureFromWorld(content_.crosshairMm()) / shown.pixelRatio;
    return {px.x, px.y};
}

// Both ends of both lines, as far as they are in the pane.
std::vector<PaneTurn::Ring> PaneTurn::ringsOn(const SliceRequest& shown) const {
    const glm::dvec2 size = glm::dvec2(shown.frame.sizePx) / shown.pixelRatio;
    const QPointF at = crosshairOn(shown);
    const bool isInside = at.x() >= 0.0 && at.y() >= 0.0 && at.x() <= size.x && at.y() <= size.y;
    if (!isInside || std::min(size.x, size.y) < kSmallestPx || !shown.showsStudy()) return {};
    const CrosshairLines lines = linesOn(shown.frame.plane);
    std::vector<Ring> rings;
    for (const bool isVertical : {true, false}) {
        const glm::dvec2& line = isVertical ? lines.vertical : lines.horizontal;
        for (const double way : {-1.0, 1.0}) {
            double edge = std::numeric_limits<double>::infinity();
            const glm::dvec2 along = way * line;
            for (const int axis : {0, 1}) {
                const double from = axis == 0 ? at.x() : at.y();
                if (along[axis] > 0.0) edge = std::min(edge, (size[axis] - from) / along[axis]);
                if (along[axis] < 0.0) edge = std::min(edge, -from / along[axis]);
            }
            const double px = kAlong * edge;
            if (px >= kNearestPx && std::isfinite(px))
                rings.push_back(
                    {.at = {at.x() + px * along.x, at.y() + px * along.y}, .isVertical = isVertical});
        }
    }
    return rings;
}

bool PaneTurn::hasRingAt(const QPointF& place, const SliceRequest& shown) const {
    return std::ranges::any_of(ringsOn(shown), [&](const Ring& ring) {
        return std::hypot(place.x() - ring.at.x(), place.y() - ring.at.y()) <= kReachPx;
    });
}

void PaneTurn::hold(const QPointF& place, const SliceRequest& shown) {
    const glm::dvec2 vertical = linesOn(shown.frame.plane).vertical;
    held_ = std::atan2(-vertical.x, vertical.y) - angleOf(crosshairOn(shown), place);
}

void PaneTurn::dragTo(const QPointF& place, const SliceRequest& shown, bool inSteps) {
    if (!held_) return;
    const slices::SlicePlane& plane = shown.frame.plane;
    const glm::dvec2 vertical = linesOn(plane).vertical;
    double wantedDeg = glm::degrees(*held_ + angleOf(crosshairOn(shown), place));
    const double step = inSteps ? kStepDeg : 90.0;
    const double caught = step * std::round(wantedDeg / step);
    if (inSteps || std::abs(wantedDeg - caught) <= kCatchDeg) wantedDeg = caught;
    turnBy(wantedDeg - turnDegOf(vertical), plane);
}

// The normal points away from the viewer, so a positive angle about it is clockwise in the picture.
void PaneTurn::turnBy(double deg, const slices::SlicePlane& plane) {
    const glm::dquat turn =
        glm::angleAxis(std::remainder(glm::radians(deg), std::numbers::pi), plane.normal());
    if (std::abs(turn.w) == 1.0) return;
    session_.drag(tr("Turn Planes"), [&](scene::StudyState& next) {
        const glm::dquat before = next.slices.turn.value_or(glm::dquat(1.0, 0.0, 0.0, 0.0));
        const glm::dquat after = glm::normalize(turn * before);
        next.slices.turn.reset();
        if (std::abs(after.w) < kStraight) next.slices.turn = after;
        // All panes turn about one point, also if nobody has chosen one yet.
        next.slices.crosshairMm = content_.crosshairMm();
    });
}

QString PaneTurn::angleText(const SliceRequest& shown, const std::optional<QPointF>& pointedAt) const {
    if (!held_ && !(pointedAt && hasRingAt(*pointedAt, shown))) return {};
    const double deg = turnDegOf(linesOn(shown.frame.plane).vertical);
    return tr("Lines turned by %1").arg(degreesText(std::abs(deg) < 0.05 ? 0.0 : deg));
}

void PaneTurn::paint(QPainter& painter, const SliceRequest& shown,
                     const std::optional<QPointF>& pointedAt) const {
    if (!pointedAt && !held_) return;
    const slices::Orientation pane = content_.orientation();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Ring& ring : ringsOn(shown)) {
        QPainterPath path;
        path.addEllipse(ring.at, kRingPx, kRingPx);
        drawHaloed(painter, path, colourOf(ring.isVertical ? verticalOf(pane) : horizontalOf(pane)), 1.5);
    }
    painter.restore();
}

}  // namespace macula::viewer
