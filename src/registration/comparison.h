// How alike two volumes are where a rigid transform lays one on the other.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "registration/intensity_bins.h"
#include "registration/joint_histogram.h"
#include "registration/pattern_search.h"
#include "registration/sample_points.h"
#include "registration/scalar_grid.h"

namespace macula::registration {

// The first three numbers turn, about the middle of the fixed volume, the others move; all in mm.
glm::dmat4 transformOf(const Parameters& p, const glm::dvec3& middleMm);

// On one level, by one set of points. The moving grid and its bins outlive it.
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
    // Likeness::normalised; minus infinity where too little of one lies in the other.
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
