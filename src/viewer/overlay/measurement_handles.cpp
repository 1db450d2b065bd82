#include "viewer/overlay/measurement_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
    const glm::dvec2 radii = std::get<Ellipse>(measurement.shape).radiiMm;
    return radii.x > 0.0 && radii.y > 0.0;
}

double distanceToSegment(const glm::dvec2& point, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + t * along);
}

}  // namespace

std::vector<glm::dvec3> handlesOf(const Measurement& measurement) {
    if (const auto* distance = std::get_if<Distance>(&measurement.shape))
        return {distance->endsMm.begin(), distance->endsMm.end()};
    if (const auto* angle = std::get_if<Angle>(&measurement.shape))
        return {angle->pointsMm.begin(), angle->pointsMm.end()};
    const Ellipse& ellipse = std::get<Ellipse>(measurement.shape);
    return {pointOf(ellipse, {1.0, 0.0}), pointOf(ellipse, {-1.0, 0.0}), pointOf(ellipse, {0.0, 1.0}),
            pointOf(ellipse, {0.0, -1.0}), ellipse.plane.centreMm};
}

Measurement withHandleAt(const Measurement& measurement, std::size_t handle, const glm::dvec3& mm) {
    const std::vector<glm::dvec3> handles = handlesOf(measurement);
    const glm::dvec3 normal = measurement.normal;
    const glm::dvec3 inPlane = mm - normal * glm::dot(mm - handles.at(handle), normal);
    Measurement moved = measurement;
    if (auto* distance = std::get_if<Distance>(&moved.shape)) {
        distance->endsMm.at(handle) = inPlane;
    } else if (auto* angle = std::get_if<Angle>(&moved.shape)) {
        angle->pointsMm.at(handle) = inPlane;
    } else {
        auto& ellipse = std::get<Ellipse>(moved.shape);
        ellipse = withHandleAt(ellipse, handle, inPlane);
    }
    return hasExtent(moved) ? moved : measurement;
}

std::vector<glm::dvec3> outlineOf(const Measurement& measurement) {
    const auto* ellipse = std::get_if<Ellipse>(&measurement.shape);
    if (ellipse == nullptr) return handlesOf(measurement);
    std::vector<glm::dvec3> outline;
    outline.reserve(kEllipseSides + 1);
    for (int side = 0; side <= kEllipseSides; ++side) {
        const double turn = 2.0 * std::numbers::pi * side / kEllipseSides;
        outline.push_back(pointOf(*ellipse, {std::cos(turn), std::sin(turn)}));
    }
    return outline;
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
        const std::vector<glm::dvec3> outline = outlineOf(measurements[i]);
        for (std::size_t p = 1; p < outline.size(); ++p) {
            const double away = distanceToSegment(px, frame.pictureFromWorld(outline[p - 1]),
                                                  frame.pictureFromWorld(outline[p]));
            if (away > linePx) continue;
            linePx = away;
            lineHit = Hit{.measurement = i};
        }
    }
    return handleHit ? handleHit : lineHit;
}

}  // namespace macula::viewer
