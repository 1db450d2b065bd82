// From values to the bins of a histogram.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/volume.h"
#include "registration/scalar_grid.h"

namespace macula::registration {

inline constexpr int kBins = 40;
// To each side of the values: a cubic B-spline reaches two bins.
inline constexpr int kMargin = 2;

// Linear between the values that all but half a per cent lie above and below; a metal clip or one hot pixel
// would else leave all tissue in one bin. Of activity (PET) linear in its root: most of a body takes up
// little.
class IntensityBins {
  public:
    // `unit` of the values of the grid. A grid that has no values, or one only, has no bins.
    IntensityBins(const ScalarGrid& grid, Unit unit);

    bool areUsable() const { return perUnit_ > 0.0; }
    // From kMargin to kBins - 1 - kMargin.
    double of(float value) const {
        const double shown = isRoot_ ? std::sqrt(std::max(double(value), 0.0)) : double(value);
        return kMargin + std::clamp((shown - low_) * perUnit_, 0.0, double(kBins - 1 - 2 * kMargin));
    }

  private:
    bool isRoot_ = false;
    double low_ = 0.0;
    double perUnit_ = 0.0;
};

}  // namespace macula::registration
