// Maps values to the bins of a histogram.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/volume.h"
#include "registration/scalar_grid.h"

namespace macula::registration {

inline constexpr int kBins = 40;
// Bins kept free at each end: a cubic B-spline reaches two bins.
inline constexpr int kMargin = 2;

// Linear between the 0.5 % and 99.5 % quantiles, because a metal clip or one hot pixel would put all tissue
// into one bin. Activity (PET) is linear in its square root, because uptake is low in most of a body.
class IntensityBins {
  public:
    // `unit` is that of the grid's values. A grid without values, or of one value only, has no usable bins.
    IntensityBins(const ScalarGrid& grid, Unit unit);

    bool areUsable() const { return perUnit_ > 0.0; }
    // The bin of a value, from kMargin to kBins - 1 - kMargin.
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
