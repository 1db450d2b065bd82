#include "pipeline/trace/point_light.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "base/check.h"

namespace macula::trace {

namespace {

// Both minimise the error of the first picture, as InitialSplatOptions do: the noise of 32 paths matters more
// than detail between neighbours.
constexpr float kReach = 3.0f;   // in radii of the point
constexpr double kFacing = 2.0;  // exponent of the cosine between the directions that two points face

// Cells of space that hold indices of points.
class Neighbours {
  public:
    Neighbours(std::span<const SurfacePoint> points, float cellMm) : cellMm_(cellMm) {
        for (std::uint32_t i = 0; i < points.size(); ++i)
            cells_[keyOf(cellOf(points[i].positionMm))].push_back(i);
    }

    // Visits all points within one cell width of `positionMm`, and some a little farther.
    template <class Visit>
    void visit(const glm::vec3& positionMm, const Visit& visit) const {
        const glm::ivec3 home = cellOf(positionMm);
        for (int n = 0; n < 27; ++n) {
            const auto found = cells_.find(keyOf(home + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1));
            if (found == cells_.end()) continue;
            for (const std::uint32_t i : found->second) visit(i);
        }
    }

  private:
    glm::ivec3 cellOf(const glm::vec3& p) const { return glm::ivec3(glm::floor(p / cellMm_)); }
    static std::uint64_t keyOf(const glm::ivec3& c) {
        constexpr std::uint64_t kMask = (1u << 21) - 1;
        return (std::uint64_t(c.x) & kMask) << 42 | (std::uint64_t(c.y) & kMask) << 21 |
               (std::uint64_t(c.z) & kMask);
    }

    float cellMm_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

float medianRadius(std::span<const SurfacePoint> points) {
    std::vector<float> radii;
    for (const SurfacePoint& point : points) radii.push_back(point.radiusMm);
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    return *middle;
}

// 1 for points that face the same way, 0 from a right angle on. A point at the centre of its matter faces
// nowhere, and shares with none.
double alike(const SurfacePoint& a, const SurfacePoint& b) {
    const double lengths = double(glm::length(a.centreMm)) * double(glm::length(b.centreMm));
    if (!(lengths > 0.0)) return 0.0;
    return std::pow(std::max(double(glm::dot(a.centreMm, b.centreMm)) / lengths, 0.0), kFacing);
}

}  // namespace

void shareLight(std::span<SurfacePoint> points, std::span<const GatheredLight> gathered) {
    MACULA_CHECK_EQ(points.size(), gathered.size());
    if (points.empty()) return;
    // In translucent matter radii differ: cells of the median radius bound the work.
    const float cellMm = kReach * medianRadius(points);
    const Neighbours neighbours(points, cellMm);
    for (SurfacePoint& point : points) {
        const float reachMm = std::min(kReach * point.radiusMm, cellMm);
        GatheredLight sum;
        neighbours.visit(point.positionMm, [&](std::uint32_t i) {
            const float apart = glm::distance(point.positionMm, points[i].positionMm) / reachMm;
            if (!(apart < 1.0f)) return;
            const double same = &point == &points[i] ? 1.0 : alike(point, points[i]);
            const double near = 1.0 - double(apart) * double(apart);
            sum.radiance += same * near * near * gathered[i].radiance;
            sum.coverage += same * near * near * gathered[i].coverage;
        });
        point.radiance = sum.coverage > 0.0 ? glm::vec3(sum.radiance / sum.coverage) : glm::vec3(0.0f);
    }
}

}  // namespace macula::trace
