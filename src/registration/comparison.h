// Measures how alike two volumes are under a rigid transform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "registration/intensity_bins.h"
#include "registration/pattern_search.h"
#include "registration/scalar_grid.h"

namespace macula::registration {

// The points of the fixed volume at which the moving one is compared.
struct SamplePoint {
    glm::dvec3 mm{0.0};  // in the world of the fixed volume
    int bin = 0;         // the bin of the fixed volume's value there
};

// About `wanted` points, spread over all cells with a value; `seed` jitters each within its cell, because
// points on a grid cause a grid of wrong answers. The result depends only on the four arguments.
std::vector<SamplePoint> samplePoints(const ScalarGrid& grid, const IntensityBins& bins, std::size_t wanted,
                                      std::uint64_t seed);

// The mutual information of two volumes: Mattes, "PET-CT image registration in the chest using free-form
// deformations", IEEE Trans Med Imaging 22 (2003), with the normalisation of Studholme, "An overlap invariant
// entropy measure of 3D medical image alignment", Pattern Recognition 32 (1999).
struct Likeness {
    double information = 0.0;  // mutual information, in nats
    // (H(fixed) + H(moving)) / H(fixed, moving): from 1, nothing in common, to 2. Unlike mutual information,
    // it does not grow merely because less of the volumes overlaps.
    double normalised = 1.0;
    double overlap = 0.0;  // share of the points where the moving volume has a value
};

// Fixed values fall into one bin, moving ones into four (a cubic B-spline), so likeness changes smoothly with
// the transform. Sums are taken in one order on any number of cores: the same points give the same bits.
Likeness likenessOf(std::span<const SamplePoint> points, const ScalarGrid& moving, const IntensityBins& bins,
                    const glm::dmat4& movingFromFixed);

// p[0] to p[2]: rotation vector about `middleMm`, in mm at a radius of 100 mm; p[3] to p[5]: shift in mm.
glm::dmat4 transformOf(const Parameters& p, const glm::dvec3& middleMm);

// Compares on one pyramid level at one set of points. The caller keeps the moving grid and its bins alive.
class Comparison {
  public:
    Comparison(std::vector<SamplePoint> points, const ScalarGrid& moving, const IntensityBins& bins,
               const glm::dvec3& middleMm, double leastOverlap)
        : points_(std::move(points)),
          moving_(moving),
          bins_(bins),
          middleMm_(middleMm),
          leastOverlap_(leastOverlap) {}

    Likeness at(const Parameters& p) const {
        return likenessOf(points_, moving_, bins_, transformOf(p, middleMm_));
    }
    // Likeness::normalised; minus infinity if the overlap is below leastOverlap.
    double score(const Parameters& p) const {
        const Likeness likeness = at(p);
        return likeness.overlap < leastOverlap_ ? -std::numeric_limits<double>::infinity()
                                                : likeness.normalised;
    }
    std::size_t pointCount() const { return points_.size(); }

  private:
    std::vector<SamplePoint> points_;
    const ScalarGrid& moving_;
    const IntensityBins& bins_;
    glm::dvec3 middleMm_;
    double leastOverlap_;
};

}  // namespace macula::registration
