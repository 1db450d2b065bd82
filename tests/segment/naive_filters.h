// Slow filters by their definitions, in double precision: the truth for those of src/segment.
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <vector>

#include "base/volume.h"
#include "base/voxel_set.h"
#include "segment/shape_filters.h"

namespace macula::segment::test {

inline void forEachVoxel(const glm::ivec3& size, const std::function<void(const glm::ivec3&)>& visit) {
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) visit({i, j, k});
}

inline VoxelSet setWhere(const glm::ivec3& size, const std::function<bool(const glm::ivec3&)>& isIn) {
    VoxelSet set(glm::ivec3(0), size - 1);
    forEachVoxel(size, [&](const glm::ivec3& v) {
        if (isIn(v)) set.add(v);
    });
    return set;
}

inline VoxelSet someVoxels(const glm::ivec3& size, double share, unsigned seed) {
    std::mt19937 random(seed);
    return setWhere(size, [&](const glm::ivec3&) { return double(random() % 1000) < 1000.0 * share; });
}

inline VoxelSet ball(const glm::ivec3& size, const glm::dvec3& spacingMm, const glm::dvec3& centreMm,
                     double radiusMm) {
    return setWhere(size, [=](const glm::ivec3& v) {
        return glm::distance(glm::dvec3(v) * spacingMm, centreMm) <= radiusMm;
    });
}

inline double distanceMm(const glm::ivec3& a, const glm::ivec3& b, const glm::dvec3& spacingMm) {
    return glm::length(glm::dvec3(a - b) * spacingMm);
}

// Whether any voxel for which isOne() holds is at most so far away.
inline bool isNear(const glm::ivec3& voxel, const SegmentGrid& grid, double mm,
                   const std::function<bool(const glm::ivec3&)>& isOne) {
    bool found = false;
    forEachVoxel(grid.size, [&](const glm::ivec3& v) {
        found = found || (isOne(v) && distanceMm(v, voxel, grid.spacingMm) <= mm * (1.0 + 1e-6));
    });
    return found;
}

// The part of a voxel, by flooding from it.
inline VoxelSet partOf(const VoxelSet& set, const glm::ivec3& size, const glm::ivec3& seed, bool corners) {
    VoxelSet part(glm::ivec3(0), size - 1);
    std::vector<glm::ivec3> todo{seed};
    part.add(seed);
    while (!todo.empty()) {
        const glm::ivec3 at = todo.back();
        todo.pop_back();
        forEachVoxel(glm::ivec3(3), [&](const glm::ivec3& step) {
            const glm::ivec3 by = step - 1;
            const int steps = std::abs(by.x) + std::abs(by.y) + std::abs(by.z);
            const glm::ivec3 v = at + by;
            if (steps == 0 || (!corners && steps > 1) || !set.contains(v) || part.contains(v)) return;
            part.add(v);
            todo.push_back(v);
        });
    }
    return part;
}

}  // namespace macula::segment::test
