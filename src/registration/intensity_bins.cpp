#include "registration/intensity_bins.h"

#include <vector>

namespace macula::registration {

namespace {

constexpr double kLeftOut = 0.005;  // share of the values at each end

bool isActivity(Unit unit) {
    return unit == Unit::becquerelsPerMillilitre || unit == Unit::suvBodyWeight;
}

}  // namespace

IntensityBins::IntensityBins(const ScalarGrid& grid, Unit unit) : isRoot_(isActivity(unit)) {
    std::vector<float> values;
    values.reserve(grid.values.size());
    for (const float value : grid.values)
        if (!std::isnan(value)) values.push_back(value);
    if (values.empty()) return;
    const auto at = [&](double share) {
        const auto place = std::ptrdiff_t(share * double(values.size() - 1));
        std::nth_element(values.begin(), values.begin() + place, values.end());
        const double value = values[std::size_t(place)];
        return isRoot_ ? std::sqrt(std::max(value, 0.0)) : value;
    };
    low_ = at(kLeftOut);
    double high = at(1.0 - kLeftOut);
    // Nearly all values are equal, as for a few voxels in an empty field: uses the full range.
    if (!(high > low_)) {
        low_ = at(0.0);
        high = at(1.0);
    }
    if (high > low_ && std::isfinite(high - low_)) perUnit_ = (kBins - 1 - 2 * kMargin) / (high - low_);
}

}  // namespace macula::registration
