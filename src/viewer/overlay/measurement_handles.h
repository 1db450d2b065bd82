// Where a measurement is taken hold of.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "slices/measurement.h"

namespace macula::viewer {

// In patient LPS mm. Of an ellipse: right, left, lower and upper end, and its centre.
std::vector<glm::dvec3> handlesOf(const slices::Measurement& measurement);

// With that handle moved to where the plane of the measurement is nearest to `mm`. An end of an ellipse takes
// the opposite one along, its centre all of it. As it was where it would lose its extent.
slices::Measurement withHandleAt(const slices::Measurement& measurement, std::size_t handle,
                                 const glm::dvec3& mm);

// The vertices of the polyline that the shape is drawn as; an ellipse is cut into short pieces.
std::vector<glm::dvec3> outlineOf(const slices::Measurement& measurement);

struct Hit {
    std::size_t measurement = 0;
    std::optional<std::size_t> handle = {};  // nothing: the line
    bool operator==(const Hit&) const = default;
};
// The nearest handle of those that are `shown` within `radiusPx` of a place in the picture; if there is none,
// the nearest line. Of measurements alike in that, the later one, which lies above.
std::optional<Hit> hitAt(std::span<const slices::Measurement> measurements, const std::vector<bool>& shown,
                         const slices::SliceFrame& frame, const glm::dvec2& px, double radiusPx);

}  // namespace macula::viewer
