// A smooth curve through points in a volume, in patient LPS mm.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "slices/slice_plane.h"

namespace macula::slices {

// A place on a curve. The three directions are perpendicular unit vectors; `across` and `beside` turn about
// the curve as little as they can from place to place.
struct CurvePlace {
    double atMm = 0.0;  // along the curve from its beginning
    glm::dvec3 mm{0.0};
    glm::dvec3 along{0.0, 0.0, 1.0};
    glm::dvec3 across{1.0, 0.0, 0.0};

    glm::dvec3 beside() const { return glm::cross(along, across); }
    // The plane across the curve; its normal is `along`.
    SlicePlane section() const { return {.centreMm = mm, .right = across, .down = beside()}; }
};

// A centripetal Catmull-Rom spline through the points (Yuksel, Schaefer and Keyser, Parameterization and
// applications of Catmull-Rom curves, 2011): it meets each of them, and has no loops between them. Its
// directions are rotation-minimising frames by double reflection (Wang, Jüttler, Zheng and Liu, Computation
// of rotation minimizing frames, 2008).
class Curve {
  public:
    // Leaves out points that are not finite, or closer than a micrometre to the one before.
    explicit Curve(std::span<const glm::dvec3> pointsMm);

    // At least two different points. The members below need it.
    bool isUsable() const { return places_.size() >= 2; }
    double lengthMm() const { return places_.back().atMm; }
    // At that length from the beginning; before it and beyond the end the curve continues straight.
    CurvePlace at(double mm) const;
    // The length at which the curve is nearest to a point.
    double nearestMm(const glm::dvec3& mm) const;
    // Places of the curve at short distances: at most kMostPlaces.
    std::span<const CurvePlace> places() const { return places_; }

    static constexpr std::size_t kMostPlaces = 100000;

  private:
    void trace(std::span<const glm::dvec3> points);
    void turnFrames();

    std::vector<CurvePlace> places_;
};

}  // namespace macula::slices
