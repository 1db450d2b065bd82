// The handles of a measurement.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "slices/measurement.h"

namespace macula::viewer {

// Handles in patient LPS mm. Those of an ellipse: right, left, lower and upper end, then centre. Of a lesion
// the ends of its first axis, then of the second. An outline has some on its rim, and one at its centre; a
// line some along it, among them its ends. Others have one at each of their points.
std::vector<glm::dvec3> handlesOf(const slices::Measurement& measurement);

// Moves that handle to the point of the measurement's plane nearest to `mm`. An ellipse's end also moves the
// opposite end; the centre of an ellipse or an outline moves the whole. The second axis of a lesion stays
// perpendicular to the first and crosses it. A handle of an outline or a line bends it as far as the next
// handles. Unchanged if the measurement would lose its extent.
slices::Measurement withHandleAt(const slices::Measurement& measurement, std::size_t handle,
                                 const glm::dvec3& mm);

// The vertices of the polylines that the shape is drawn as; an ellipse is cut into short pieces.
std::vector<std::vector<glm::dvec3>> linesOf(const slices::Measurement& measurement);

struct Hit {
    std::size_t measurement = 0;
    std::optional<std::size_t> handle = {};  // nothing: its line
    bool operator==(const Hit&) const = default;
};
// The nearest handle of a `shown` measurement within `radiusPx` of a place in the picture; without one, the
// nearest line. Of equally near ones the later, which lies above.
std::optional<Hit> hitAt(std::span<const slices::Measurement> measurements, const std::vector<bool>& shown,
                         const slices::SliceFrame& frame, const glm::dvec2& px, double radiusPx);

}  // namespace macula::viewer
