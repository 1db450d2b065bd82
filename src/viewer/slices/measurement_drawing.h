// A measurement while a person draws it.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "slices/measurement.h"
#include "slices/slice_plane.h"
#include "viewer/keys/slice_tool.h"

namespace macula::viewer {

// A distance has two points, its ends; an arrow its tip, then its tail; an ellipse two opposite corners of
// its box; an angle three points; a Cobb angle the ends of two lines; a lesion the ends of its first axis,
// and a point as far from it as the second one reaches on each side of its middle. A press of the button sets
// a point; a release after a drag also sets the second, and the fourth. Outlines and lines follow a drag
// until its release; clicked instead, they have a point for each press until one at the last point, or at the
// first of an outline. All points lie in `plane`, patient LPS mm.
class MeasurementDrawing {
  public:
    // `tool` must measure. Points within `leastMm` of each other count as one.
    MeasurementDrawing(SliceTool tool, const slices::SlicePlane& plane, const glm::dvec3& firstMm,
                       double leastMm);

    void press(const glm::dvec3& mm);
    void move(const glm::dvec3& mm, bool isHeld = false);  // whether the button is down
    void release(const glm::dvec3& mm);

    const slices::SlicePlane& plane() const { return plane_; }
    std::size_t pointsSet() const { return pointsMm_.size(); }
    bool isComplete() const { return isFreehand() ? isEnded_ : pointsMm_.size() == pointsNeeded(); }
    bool isFreehand() const { return tool_ == SliceTool::outline || tool_ == SliceTool::line; }
    // The measurement with the pointer as its next point; what has too few points for its shape is a
    // distance. Nothing while it has no extent. A complete outline has no loop where the hand overshot, and
    // both it and a line only as many points as they need.
    std::optional<slices::Measurement> soFar() const;

  private:
    std::size_t pointsNeeded() const;
    bool isNew(const glm::dvec3& mm) const;
    void follow(const glm::dvec3& mm);
    void endFreehand();
    slices::Measurement measured(decltype(slices::Measurement::shape) shape) const;
    std::optional<slices::Measurement> ellipse(const glm::dvec3& to) const;
    std::optional<slices::Measurement> lesion(const glm::dvec3& to) const;
    std::optional<slices::Measurement> freehand() const;
    std::vector<glm::dvec3> kept() const;
    double offFirstLineMm(const glm::dvec3& mm) const;

    SliceTool tool_;
    slices::SlicePlane plane_;
    double leastMm_;
    std::vector<glm::dvec3> pointsMm_;
    glm::dvec3 pointerMm_;
    bool isDragged_ = false;  // a drag drew points since the last press
    bool isEnded_ = false;
};

}  // namespace macula::viewer
