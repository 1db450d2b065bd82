#include "segment/brush.h"

#include <algorithm>
#include <cmath>

namespace macula::segment {

namespace {

double distanceMm(const glm::dvec3& point, const Stroke& stroke) {
    const glm::dvec3 way = stroke.toMm - stroke.fromMm;
    const double squared = glm::dot(way, way);
    const double part =
        squared > 0.0 ? std::clamp(glm::dot(point - stroke.fromMm, way) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(point, stroke.fromMm + part * way);
}

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

VoxelSet voxelsUnder(const Stroke& stroke, const glm::dmat4& worldFromVoxel, const glm::ivec3& size) {
    if (!isFinite(stroke.fromMm) || !isFinite(stroke.toMm) || !std::isfinite(stroke.radiusMm)) return {};
    const double radiusMm = std::clamp(stroke.radiusMm, 0.0, kLargestBrushMm);
    const glm::dmat4 voxelFromWorld = glm::inverse(worldFromVoxel);
    // How far a ball reaches along each axis of the grid, in voxels: the lengths of the rows of the inverse.
    const glm::dmat3 rows = glm::transpose(glm::dmat3(voxelFromWorld));
    const glm::dvec3 reach(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
    const glm::dvec3 a = transformPoint(voxelFromWorld, stroke.fromMm);
    const glm::dvec3 b = transformPoint(voxelFromWorld, stroke.toMm);
    const glm::dvec3 most = glm::dvec3(size - 1);
    const glm::dvec3 low = glm::clamp(glm::floor(glm::min(a, b) - radiusMm * reach), glm::dvec3(0.0), most);
    const glm::dvec3 high = glm::clamp(glm::ceil(glm::max(a, b) + radiusMm * reach), glm::dvec3(0.0), most);
    VoxelSet set{glm::ivec3(low), glm::ivec3(high)};
    // Half the distance of neighbouring planes of voxels along the normal.
    double halfMm = 0.0;
    if (stroke.sliceNormal)
        for (int axis = 0; axis < 3; ++axis)
            halfMm = std::max(
                halfMm, 0.5 * std::abs(glm::dot(glm::dvec3(worldFromVoxel[axis]), *stroke.sliceNormal)));
    constexpr double kRounding = 1e-9;
    for (int k = set.low().z; k <= set.high().z; ++k)
        for (int j = set.low().y; j <= set.high().y; ++j)
            for (int i = set.low().x; i <= set.high().x; ++i) {
                const glm::dvec3 mm = transformPoint(worldFromVoxel, {i, j, k});
                if (distanceMm(mm, stroke) > radiusMm + kRounding) continue;
                if (stroke.sliceNormal &&
                    std::abs(glm::dot(mm - stroke.fromMm, *stroke.sliceNormal)) > halfMm * (1.0 - kRounding))
                    continue;
                set.add({i, j, k});
            }
    for (const glm::dvec3& end : {a, b}) {
        const glm::dvec3 nearest = glm::round(end);
        if (glm::all(glm::greaterThanEqual(nearest, glm::dvec3(0.0))) &&
            glm::all(glm::lessThanEqual(nearest, most)))
            set.add(glm::ivec3(nearest));
    }
    return set.cropped();
}

}  // namespace macula::segment
