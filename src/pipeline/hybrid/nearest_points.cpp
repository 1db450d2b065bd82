#include "pipeline/hybrid/nearest_points.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace macula::hybrid {

std::size_t NearestPoints::Hash::operator()(const Cell& cell) const {
    const auto mixed = [](std::int64_t value, std::uint64_t by) {
        const std::uint64_t product = static_cast<std::uint64_t>(value) * by;
        return product ^ (product >> 29);
    };
    return mixed(cell.x, 0x9e3779b97f4a7c15u) ^ mixed(cell.y, 0xc2b2ae3d27d4eb4fu) ^
           mixed(cell.z, 0x165667b19e3779f9u);
}

NearestPoints::NearestPoints(std::span<const glm::vec3> points, double nearMm)
    : points_(points.begin(), points.end()), nearMm_(nearMm) {
    MACULA_CHECK(nearMm > 0.0);
    for (std::size_t i = 0; i < points_.size(); ++i)
        cells_[cellOf(points_[i])].push_back(static_cast<std::uint32_t>(i));
}

// Beyond 2^40 cells all is one cell: nothing is so far away.
NearestPoints::Cell NearestPoints::cellOf(const glm::vec3& place) const {
    constexpr double kMost = 1099511627776.0;
    return {glm::clamp(glm::floor(glm::dvec3(place) / nearMm_), -kMost, kMost)};
}

std::optional<std::size_t> NearestPoints::nearest(const glm::vec3& place) const {
    std::optional<std::size_t> best;
    double least = nearMm_ * nearMm_;
    const Cell middle = cellOf(place);
    for (std::int64_t k = -1; k <= 1; ++k)
        for (std::int64_t j = -1; j <= 1; ++j)
            for (std::int64_t i = -1; i <= 1; ++i) {
                const auto found = cells_.find(middle + Cell(i, j, k));
                if (found == cells_.end()) continue;
                for (const std::uint32_t point : found->second) {
                    const glm::dvec3 off = glm::dvec3(points_[point]) - glm::dvec3(place);
                    const double square = glm::dot(off, off);
                    if (square < least || (square == least && (!best || point < *best))) {
                        least = square;
                        best = point;
                    }
                }
            }
    return best;
}

}  // namespace macula::hybrid
