#include "registration/sample_points.h"

#include <algorithm>

namespace macula::registration {

namespace {

// SplitMix64: a 64-bit number for each counter.
std::uint64_t mixed(std::uint64_t counter) {
    std::uint64_t z = counter + 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
}

// A number from 0 (inclusive) to 1 (exclusive).
double share(std::uint64_t seed, std::uint64_t counter) {
    constexpr double kTo53Bits = 1.0 / 9007199254740992.0;
    return double(mixed(mixed(seed) + counter) >> 11U) * kTo53Bits;
}

}  // namespace

std::vector<SamplePoint> samplePoints(const ScalarGrid& grid, const IntensityBins& bins, std::size_t wanted,
                                      std::uint64_t seed) {
    const std::size_t cells = grid.values.size();
    const auto valid =
        std::size_t(std::ranges::count_if(grid.values, [](float value) { return !std::isnan(value); }));
    if (valid == 0 || wanted == 0) return {};
    // Draws more than wanted, because draws without a value are dropped.
    const std::size_t draws = std::min(cells, std::size_t(double(wanted) * double(cells) / double(valid)));
    std::vector<SamplePoint> points;
    points.reserve(std::min(wanted, draws) + 1);
    const auto width = std::size_t(grid.size.x);
    const auto height = std::size_t(grid.size.y);
    for (std::size_t n = 0; n < draws; ++n) {
        const double along = (double(n) + share(seed, 4 * n)) * double(cells) / double(draws);
        const std::size_t at = std::min(std::size_t(along), cells - 1);
        const std::size_t row = at / width;
        const std::size_t slice = row / height;
        const glm::dvec3 cell(double(at % width) + share(seed, 4 * n + 1),
                              double(row % height) + share(seed, 4 * n + 2),
                              double(slice) + share(seed, 4 * n + 3));
        const float value = grid.at(cell);
        if (std::isnan(value)) continue;
        points.push_back({transformPoint(grid.worldFromGrid, cell), int(std::lround(bins.of(value)))});
    }
    return points;
}

}  // namespace macula::registration
