#include "viewer/slices/measurement_drawing.h"

#include <utility>

#include "base/check.h"

namespace macula::viewer {

MeasurementDrawing::MeasurementDrawing(SliceTool tool, const slices::SlicePlane& plane,
                                       const glm::dvec3& firstMm, double leastMm)
    : tool_(tool), plane_(plane), leastMm_(leastMm), pointsMm_{firstMm}, pointerMm_(firstMm) {
    MACULA_CHECK(measures(tool));
}

void MeasurementDrawing::press(const glm::dvec3& mm) {
    pointerMm_ = mm;
    if (!isComplete() && isNew(mm)) pointsMm_.push_back(mm);
}

void MeasurementDrawing::release(const glm::dvec3& mm) {
    pointerMm_ = mm;
    if (pointsMm_.size() == 1 && isNew(mm)) pointsMm_.push_back(mm);
}

std::optional<slices::Measurement> MeasurementDrawing::soFar() const {
    const glm::dvec3 last = isComplete() ? pointsMm_.back() : pointerMm_;
    const auto measured = [this](auto shape) {
        return slices::Measurement{.shape = std::move(shape), .normal = plane_.normal()};
    };
    if (!isComplete() && !isNew(last)) return std::nullopt;
    if (tool_ == SliceTool::ellipse) return ellipse(last);
    if (tool_ == SliceTool::angle && pointsMm_.size() > 1)
        return measured(slices::Angle{.pointsMm = {pointsMm_[0], pointsMm_[1], last}});
    return measured(slices::Distance{.endsMm = {pointsMm_[0], last}});
}

// The ellipse in the rectangle between two opposite corners.
std::optional<slices::Measurement> MeasurementDrawing::ellipse(const glm::dvec3& to) const {
    const glm::dvec3 diagonal = to - pointsMm_.front();
    slices::Ellipse ellipse{.plane = plane_,
                            .radiiMm = 0.5 * glm::abs(glm::dvec2(glm::dot(diagonal, plane_.right),
                                                                 glm::dot(diagonal, plane_.down)))};
    ellipse.plane.centreMm = pointsMm_.front() + 0.5 * diagonal;
    if (!(ellipse.radiiMm.x > 0.0) || !(ellipse.radiiMm.y > 0.0)) return std::nullopt;
    return slices::Measurement{.shape = ellipse, .normal = plane_.normal()};
}

}  // namespace macula::viewer
