// A measurement that a person is drawing.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "slices/measurement.h"
#include "viewer/keys/slice_tool.h"

namespace macula::viewer {

// A distance has two points, its ends; an ellipse two opposite corners of its box; an angle three points. A
// press of the button sets a point; a release after a drag also sets the second. All points lie in `plane`,
// patient LPS mm.
class MeasurementDrawing {
  public:
    // `tool` must measure. Points within `leastMm` of each other count as one.
    MeasurementDrawing(SliceTool tool, const slices::SlicePlane& plane, const glm::dvec3& firstMm,
                       double leastMm);

    void press(const glm::dvec3& mm);
    void move(const glm::dvec3& mm) { pointerMm_ = mm; }
    void release(const glm::dvec3& mm);

    const slices::SlicePlane& plane() const { return plane_; }
    std::size_t pointsSet() const { return pointsMm_.size(); }
    bool isComplete() const { return pointsMm_.size() == pointsNeeded(); }
    // The measurement with the pointer as its next point; an angle with one point gives its first leg as a
    // distance. Nothing while it has no extent.
    std::optional<slices::Measurement> soFar() const;

  private:
    std::size_t pointsNeeded() const { return tool_ == SliceTool::angle ? 3 : 2; }
    bool isNew(const glm::dvec3& mm) const { return glm::distance(pointsMm_.back(), mm) > leastMm_; }
    std::optional<slices::Measurement> ellipse(const glm::dvec3& to) const;

    SliceTool tool_;
    slices::SlicePlane plane_;
    double leastMm_;
    std::vector<glm::dvec3> pointsMm_;
    glm::dvec3 pointerMm_;
};

}  // namespace macula::viewer
