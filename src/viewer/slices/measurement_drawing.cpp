#include "viewer/slices/measurement_drawing.h"

#include <cmath>
#include <utility>

#include "base/check.h"
#include "scene/state/measurements_json.h"
#include "slices/outline.h"

namespace macula::viewer {

namespace {

// Of the distance within which two points are one, which is three pixels.
constexpr double kStep = 1.0 / 3.0;       // between points of a drag
constexpr double kTolerance = 1.0 / 6.0;  // from what was drawn to what is kept
constexpr std::size_t kMostDrawn = 4000;  // before they are thinned out

}  // namespace

MeasurementDrawing::MeasurementDrawing(SliceTool tool, const slices::SlicePlane& plane,
                                       const glm::dvec3& firstMm, double leastMm)
    : tool_(tool), plane_(plane), leastMm_(leastMm), pointsMm_{firstMm}, pointerMm_(firstMm) {
    MACULA_CHECK(measures(tool));
}

std::size_t MeasurementDrawing::pointsNeeded() const {
    switch (tool_) {
        case SliceTool::angle:
        case SliceTool::bidirectional:
            return 3;
        case SliceTool::cobb:
            return 4;
        default:
            return 2;
    }
}

// The third point of a lesion says how far its second axis reaches.
bool MeasurementDrawing::isNew(const glm::dvec3& mm) const {
    if (tool_ == SliceTool::bidirectional && pointsMm_.size() == 2)
        return offFirstLineMm(mm) > kStep * leastMm_;
    return glm::distance(pointsMm_.back(), mm) > leastMm_;
}

void MeasurementDrawing::press(const glm::dvec3& mm) {
    pointerMm_ = mm;
    isDragged_ = false;
    if (isComplete()) return;
    if (isFreehand()) {
        const bool isClosed = tool_ == SliceTool::outline &&
                              pointsMm_.size() >= slices::kFewestOutlinePoints &&
                              glm::distance(pointsMm_.front(), mm) <= leastMm_;
        if (isClosed || !isNew(mm)) return endFreehand();
    }
    if (isNew(mm)) pointsMm_.push_back(mm);
}

void MeasurementDrawing::move(const glm::dvec3& mm, bool isHeld) {
    pointerMm_ = mm;
    if (isFreehand() && isHeld && !isComplete()) follow(mm);
}

void MeasurementDrawing::follow(const glm::dvec3& mm) {
    // A click that shakes is no drag.
    if (glm::distance(pointsMm_.back(), mm) <= (isDragged_ ? kStep : 1.0) * leastMm_) return;
    isDragged_ = true;
    if (pointsMm_.size() == kMostDrawn) pointsMm_ = slices::simplified(pointsMm_, kTolerance * leastMm_);
    if (pointsMm_.size() < kMostDrawn) pointsMm_.push_back(mm);
}

void MeasurementDrawing::release(const glm::dvec3& mm) {
    pointerMm_ = mm;
    if (isFreehand()) {
        follow(mm);
        if (isDragged_) endFreehand();
        return;
    }
    const bool endsALine = pointsMm_.size() == 1 || (tool_ == SliceTool::cobb && pointsMm_.size() == 3);
    if (endsALine && isNew(mm)) pointsMm_.push_back(mm);
}

// A line or an outline with too few points goes on.
void MeasurementDrawing::endFreehand() {
    const std::size_t fewest = tool_ == SliceTool::outline ? slices::kFewestOutlinePoints : 2;
    isEnded_ = pointsMm_.size() >= fewest;
}

slices::Measurement MeasurementDrawing::measured(decltype(slices::Measurement::shape) shape) const {
    return slices::Measurement{.shape = std::move(shape), .normal = plane_.normal()};
}

std::optional<slices::Measurement> MeasurementDrawing::soFar() const {
    if (isFreehand()) return freehand();
    const std::vector<glm::dvec3>& p = pointsMm_;
    const glm::dvec3 last = isComplete() ? p.back() : pointerMm_;
    const bool hasLine = p.size() > 1;
    if (!isComplete() && !isNew(last)) {
        if (!hasLine) return std::nullopt;
        if (tool_ == SliceTool::angle || p.size() == 2) return measured(slices::Distance{{p[0], p[1]}});
    }
    switch (tool_) {
        case SliceTool::ellipse:
            return ellipse(last);
        case SliceTool::arrow:
            return measured(slices::Arrow{p[0], last});
        case SliceTool::bidirectional:
            if (hasLine) return lesion(last);
            break;
        case SliceTool::angle:
            if (hasLine) return measured(slices::Angle{{p[0], p[1], last}});
            break;
        case SliceTool::cobb:
            if (p.size() > 2) return measured(slices::CobbAngle{{p[0], p[1], p[2], last}});
            if (hasLine) return measured(slices::Distance{{p[0], p[1]}});
            break;
        default:
            break;
    }
    return measured(slices::Distance{{p[0], last}});
}

// The ellipse in the rectangle between two opposite corners.
std::optional<slices::Measurement> MeasurementDrawing::ellipse(const glm::dvec3& to) const {
    const glm::dvec3 diagonal = to - pointsMm_.front();
    slices::Ellipse ellipse{.plane = plane_,
                            .radiiMm = 0.5 * glm::abs(glm::dvec2(glm::dot(diagonal, plane_.right),
                                                                 glm::dot(diagonal, plane_.down)))};
    ellipse.plane.centreMm = pointsMm_.front() + 0.5 * diagonal;
    if (!(ellipse.radiiMm.x > 0.0) || !(ellipse.radiiMm.y > 0.0)) return std::nullopt;
    return measured(ellipse);
}

double MeasurementDrawing::offFirstLineMm(const glm::dvec3& mm) const {
    const glm::dvec3 across = glm::normalize(glm::cross(plane_.normal(), pointsMm_[1] - pointsMm_[0]));
    return std::abs(glm::dot(mm - pointsMm_[0], across));
}

// Both axes cross in the middle of both.
std::optional<slices::Measurement> MeasurementDrawing::lesion(const glm::dvec3& to) const {
    const glm::dvec3& from = pointsMm_[0];
    const glm::dvec3& end = pointsMm_[1];
    const glm::dvec3 across = glm::normalize(glm::cross(plane_.normal(), end - from));
    const glm::dvec3 reach = offFirstLineMm(isComplete() ? pointsMm_[2] : to) * across;
    const glm::dvec3 middle = 0.5 * (from + end);
    return measured(
        slices::Bidirectional{.firstMm = {from, end}, .secondMm = {middle - reach, middle + reach}});
}

std::vector<glm::dvec3> MeasurementDrawing::kept() const {
    double toleranceMm = kTolerance * leastMm_;
    std::vector<glm::dvec3> points = slices::simplified(pointsMm_, toleranceMm);
    while (points.size() > scene::kMostDrawnPoints) points = slices::simplified(points, toleranceMm *= 2.0);
    return points;
}

std::optional<slices::Measurement> MeasurementDrawing::freehand() const {
    std::vector<glm::dvec3> points = isEnded_ ? kept() : pointsMm_;
    if (!isEnded_ && glm::distance(points.back(), pointerMm_) > 0.0) points.push_back(pointerMm_);
    if (points.size() < 2) return std::nullopt;
    if (tool_ == SliceTool::line || points.size() < slices::kFewestOutlinePoints)
        return isEnded_ && tool_ == SliceTool::outline
                   ? std::nullopt
                   : std::optional(measured(slices::OpenLine{std::move(points)}));
    if (!isEnded_) return measured(slices::Outline{std::move(points)});
    std::vector<glm::dvec2> flat;
    for (const glm::dvec3& mm : points)
        flat.emplace_back(glm::dot(mm - plane_.centreMm, plane_.right),
                          glm::dot(mm - plane_.centreMm, plane_.down));
    slices::Outline outline;
    for (const glm::dvec2& mm : slices::largestLoop(flat))
        outline.pointsMm.push_back(plane_.centreMm + mm.x * plane_.right + mm.y * plane_.down);
    if (!(slices::areaMm2(outline) > 0.0)) return std::nullopt;
    return measured(std::move(outline));
}

}  // namespace macula::viewer
