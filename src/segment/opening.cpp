#include "segment/opening.h"

#include <algorithm>

#include "segment/distance.h"

namespace macula::segment {

Opened opened(const Grid& grid, const Mask& mask, double radiusMm) {
    Mask other(mask.size());
    std::transform(mask.begin(), mask.end(), other.begin(),
                   [](std::uint8_t in) { return std::uint8_t(in != 0 ? 0 : 1); });
    std::vector<float> depthMm = distanceTo(grid, other);
    const auto radius = static_cast<float>(radiusMm);
    std::transform(depthMm.begin(), depthMm.end(), other.begin(),
                   [&](float depth) { return std::uint8_t(depth > radius ? 1 : 0); });
    const std::vector<float> toCore = distanceTo(grid, other);
    for (std::size_t n = 0; n < mask.size(); ++n) other[n] = mask[n] != 0 && toCore[n] <= radius ? 1 : 0;
    return {std::move(other), std::move(depthMm)};
}

}  // namespace macula::segment
