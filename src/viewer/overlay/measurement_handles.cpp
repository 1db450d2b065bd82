#include "viewer/overlay/measurement_handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "viewer/overlay/freehand_handles.h"

namespace macula::viewer {

namespace {

using slices::Angle;
using slices::Distance;
using slices::Ellipse;
using slices::Measurement;

constexpr std::size_t kCentre = 4;  // index of an ellipse's centre handle
constexpr int kEllipseSides = 96;   // within a quarter of a pixel at a radius of 500

glm::dvec3 pointOf(const Ellipse& ellipse, const glm::dvec2& radii) {
    return ellipse.plane.centreMm + ellipse.plane.right * (radii.x * ellipse.radiiMm.x) +
           ellipse.plane.down * (radii.y * ellipse.radiiMm.y);
}

Ellipse withHandleAt(Ellipse ellipse, std::size_t handle, const glm::dvec3& mm) {
    if (handle == kCentre) {
        ellipse.plane.centreMm = mm;
        return ellipse;
    }
    const glm::dvec3 fromCentre = mm - ellipse.plane.centreMm;
    if (handle < 2) {
        ellipse.radiiMm.x = std::abs(glm::dot(fromCentre, ellipse.plane.right));
    } else {
        ellipse.radiiMm.y = std::abs(glm::dot(fromCentre, ellipse.plane.down));
    }
    return ellipse;
}

bool hasExtent(const Measurement& measurement) {
    if (const auto* distance = std::get_if<Distance>(&measurement.shape))
        return slices::lengthMm(*distance) > 0.0;
    if (const auto* angle = std::get_if<Angle>(&measurement.shape))
        return angle->pointsMm[0] != angle->pointsMm[1] && angle->pointsMm[2] != angle->pointsMm[1];
    if (const auto* ellipse = std::get_if<Ellipse>(&measurement.shape))
        return ellipse->radiiMm.x > 0.0 && ellipse->radiiMm.y > 0.0;
    if (const auto* lesion = std::get_if<slices::Bidirectional>(&measurement.shape))
        return slices::axesOf(*lesion).shortMm > 0.0;
    if (const auto* cobb = std::get_if<slices::CobbAngle>(&measurement.shape))
        return cobb->pointsMm[0] != cobb->pointsMm[1] && cobb->pointsMm[2] != cobb->pointsMm[3];
    if (const auto* arrow = std::get_if<slices::Arrow>(&measurement.shape))
        return arrow->tipMm != arrow->tailMm;
    return true;  // bent lines keep one
}

// Where the second axis crosses the first, as a part of it, and how far its ends reach to both sides.
struct Crossing {
    double part = 0.5;
    std::array<double, 2> reachMm{};
};

glm::dvec3 acrossOf(const slices::Bidirectional& lesion, const glm::dvec3& normal) {
    return glm::normalize(glm::cross(normal, lesion.firstMm[1] - lesion.firstMm[0]));
}

Crossing crossingOf(const slices::Bidirectional& lesion, const glm::dvec3& normal) {
    const glm::dvec3 along = lesion.firstMm[1] - lesion.firstMm[0];
    const glm::dvec3 across = acrossOf(lesion, normal);
    Crossing crossing;
    const glm::dvec3 middle = 0.5 * (lesion.secondMm[0] + lesion.secondMm[1]) - lesion.firstMm[0];
    crossing.part = std::clamp(glm::dot(middle, along) / glm::dot(along, along), 0.0, 1.0);
    for (std::size_t end = 0; end < 2; ++end)
        crossing.reachMm.at(end) = glm::dot(lesion.secondMm.at(end) - lesion.firstMm[0], across);
    return crossing;
}

void cross(slices::Bidirectional& lesion, const Crossing& crossing, const glm::dvec3& normal) {
    const glm::dvec3 foot = glm::mix(lesion.firstMm[0], lesion.firstMm[1], crossing.part);
    const glm::dvec3 across = acrossOf(lesion, normal);
    for (std::size_t end = 0; end < 2; ++end)
        lesion.secondMm.at(end) = foot + crossing.reachMm.at(end) * across;
}

slices::Bidirectional withHandleAt(slices::Bidirectional lesion, std::size_t handle, const glm::dvec3& mm,
                                   const glm::dvec3& normal) {
    if (lesion.firstMm[0] == lesion.firstMm[1]) return lesion;  // of a hostile file
    Crossing crossing = crossingOf(lesion, normal);
    if (handle < 2) {
        lesion.firstMm.at(handle) = mm;
        if (lesion.firstMm[0] == lesion.firstMm[1]) return {};
    } else {
        const std::size_t end = handle - 2;
        const glm::dvec3 along = lesion.firstMm[1] - lesion.firstMm[0];
        const glm::dvec3 from = mm - lesion.firstMm[0];
        crossing.part = std::clamp(glm::dot(from, along) / glm::dot(along, along), 0.0, 1.0);
        // Each end stays on its side of the first axis.
        const double other = crossing.reachMm.at(1 - end);
        const double reach = glm::dot(from, acrossOf(lesion, normal));
        const bool isAbove = other != 0.0 ? other < 0.0 : crossing.reachMm.at(end) > 0.0;
        crossing.reachMm.at(end) = isAbove ? std::max(reach, 0.0) : std::min(reach, 0.0);
    }
    cross(lesion, crossing, normal);
    return lesion;
}

double distanceToSegment(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + t * along);
}

double distanceToLines(const glm::dvec2& px, const std::vector<std::vector<glm::dvec3>>& lines,
                       const slices::SliceFrame& frame) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::vector<glm::dvec3>& line : lines) {
        for (std::size_t p = 1; p < line.size(); ++p)
            nearest = std::min(nearest, distanceToSegment(px, frame.pictureFromWorld(line[p - 1]),
                                                          frame.pictureFromWorld(line[p])));
    }
    return nearest;
}

}  // namespace

std::vector<glm::dvec3> handlesOf(const Measurement& measurement) {
    if (const auto* outline = std::get_if<slices::Outline>(&measurement.shape))
        return freehandHandles(outline->pointsMm, Freehand::closed);
    if (const auto* line = std::get_if<slices::OpenLine>(&measurement.shape))
        return freehandHandles(line->pointsMm, Freehand::open);
    const auto* ellipse = std::get_if<Ellipse>(&measurement.shape);
    if (ellipse == nullptr) return slices::pointsOf(measurement);
    return {pointOf(*ellipse, {1.0, 0.0}), pointOf(*ellipse, {-1.0, 0.0}), pointOf(*ellipse, {0.0, 1.0}),
            pointOf(*ellipse, {0.0, -1.0}), ellipse->plane.centreMm};
}

Measurement withHandleAt(const Measurement& measurement, std::size_t handle, const glm::dvec3& mm) {
    const std::vector<glm::dvec3> handles = handlesOf(measurement);
    const glm::dvec3 normal = measurement.normal;
    const glm::dvec3 inPlane = mm - normal * glm::dot(mm - handles.at(handle), normal);
    Measurement moved = measurement;
    if (auto* distance = std::get_if<Distance>(&moved.shape)) distance->endsMm.at(handle) = inPlane;
    if (auto* angle = std::get_if<Angle>(&moved.shape)) angle->pointsMm.at(handle) = inPlane;
    if (auto* cobb = std::get_if<slices::CobbAngle>(&moved.shape)) cobb->pointsMm.at(handle) = inPlane;
    if (auto* arrow = std::get_if<slices::Arrow>(&moved.shape))
        (handle == 0 ? arrow->tipMm : arrow->tailMm) = inPlane;
    if (auto* ellipse = std::get_if<Ellipse>(&moved.shape))
        *ellipse = withHandleAt(*ellipse, handle, inPlane);
    if (auto* lesion = std::get_if<slices::Bidirectional>(&moved.shape)) {
        const bool isNode = lesion->isNode;
        *lesion = withHandleAt(*lesion, handle, inPlane, normal);
        lesion->isNode = isNode;
    }
    const glm::dvec3 by = inPlane - handles.at(handle);
    if (auto* outline = std::get_if<slices::Outline>(&moved.shape))
        outline->pointsMm = withFreehandMoved(std::move(outline->pointsMm), handle, by, Freehand::closed);
    if (auto* line = std::get_if<slices::OpenLine>(&moved.shape))
        line->pointsMm = withFreehandMoved(std::move(line->pointsMm), handle, by, Freehand::open);
    return hasExtent(moved) ? moved : measurement;
}

std::vector<std::vector<glm::dvec3>> linesOf(const Measurement& measurement) {
    if (const auto* lesion = std::get_if<slices::Bidirectional>(&measurement.shape))
        return {{lesion->firstMm[0], lesion->firstMm[1]}, {lesion->secondMm[0], lesion->secondMm[1]}};
    if (const auto* cobb = std::get_if<slices::CobbAngle>(&measurement.shape))
        return {{cobb->pointsMm[0], cobb->pointsMm[1]}, {cobb->pointsMm[2], cobb->pointsMm[3]}};
    const auto* ellipse = std::get_if<Ellipse>(&measurement.shape);
    std::vector<glm::dvec3> line;
    if (ellipse == nullptr) {
        line = slices::pointsOf(measurement);
        const bool isClosed = std::holds_alternative<slices::Outline>(measurement.shape) && !line.empty();
        if (isClosed) line.push_back(line.front());
        return {std::move(line)};
    }
    line.reserve(kEllipseSides + 1);
    for (int side = 0; side <= kEllipseSides; ++side) {
        const double turn = 2.0 * std::numbers::pi * side / kEllipseSides;
        line.push_back(pointOf(*ellipse, {std::cos(turn), std::sin(turn)}));
    }
    return {std::move(line)};
}

std::optional<Hit> hitAt(std::span<const Measurement> measurements, const std::vector<bool>& shown,
                         const slices::SliceFrame& frame, const glm::dvec2& px, double radiusPx) {
    std::optional<Hit> handleHit;
    std::optional<Hit> lineHit;
    double handlePx = radiusPx;
    double linePx = radiusPx;
    for (std::size_t i = 0; i < measurements.size(); ++i) {
        if (i >= shown.size() || !shown[i]) continue;
        const std::vector<glm::dvec3> handles = handlesOf(measurements[i]);
        for (std::size_t h = 0; h < handles.size(); ++h) {
            const double away = glm::distance(frame.pictureFromWorld(handles[h]), px);
            if (away > handlePx) continue;
            handlePx = away;
            handleHit = Hit{.measurement = i, .handle = h};
        }
        const double away = distanceToLines(px, linesOf(measurements[i]), frame);
        if (away > linePx) continue;
        linePx = away;
        lineHit = Hit{.measurement = i};
    }
    return handleHit ? handleHit : lineHit;
}

}  // namespace macula::viewer
