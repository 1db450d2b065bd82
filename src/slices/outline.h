// Polygons in a plane, as a hand draws them.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "slices/measurement.h"
#include "slices/slice_plane.h"

namespace macula::slices {

inline constexpr std::size_t kFewestOutlinePoints = 3;

// An outline in (u, v), in mm along right and down of its plane; the centre of the plane is in the middle of
// the points.
struct FlatOutline {
    SlicePlane plane;
    std::vector<glm::dvec2> points;
};

// In the plane with that normal through the middle of the points. Nothing for fewer than three points, or
// where a number is not finite or farther than a million km.
std::optional<FlatOutline> flatOutline(const Outline& outline, const glm::dvec3& normal);
// In the plane that fits it best (Newell). Nothing also where the points enclose nothing.
std::optional<FlatOutline> flatOutline(const Outline& outline);

// These four take a polygon that goes back from its last point to the first.
double signedArea(std::span<const glm::dvec2> polygon);  // positive from u to v
// Nothing without an area.
std::optional<glm::dvec2> centroidOf(std::span<const glm::dvec2> polygon);
// Whether two of its sides cross; sides that only touch do not count.
bool crossesItself(std::span<const glm::dvec2> polygon);
// Of a polygon that crosses itself the largest loop, so that a hand may overshoot where it closes the
// outline. Equal to the polygon if it does not cross itself.
std::vector<glm::dvec2> largestLoop(std::span<const glm::dvec2> polygon);

// Fewer points of the same line: none of those that are left out is farther than `toleranceMm` from it
// (Ramer, Douglas and Peucker). Keeps both ends.
std::vector<glm::dvec3> simplified(std::span<const glm::dvec3> line, double toleranceMm);

// Whether points lie in a polygon: inside, where a ray from there crosses its sides an odd number of times,
// or on its rim to a nanometre. Much faster than looking at each side for each point.
class InsideOf {
  public:
    explicit InsideOf(std::span<const glm::dvec2> polygon);

    bool operator()(const glm::dvec2& at) const;

  private:
    struct Side {
        glm::dvec2 from{0.0};
        glm::dvec2 to{0.0};
    };
    const std::vector<Side>& bandAt(double v) const;

    double low_ = 0.0, high_ = 0.0;         // of v
    std::vector<std::vector<Side>> bands_;  // the sides that reach into each band of v
};

}  // namespace macula::slices
