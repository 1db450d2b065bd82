// The slow truth: optical depth along a ray, in double, from the volume and the transfer function themselves;
// shares nothing with the tracers but those.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::scenes {

// Trilinear between voxel centres; beyond the outer ones the outer voxel goes on. `voxel` has integers at
// centres.
inline double valueAt(const Volume& volume, glm::dvec3 voxel) {
    const glm::dvec3 last(volume.size() - 1);
    voxel = glm::clamp(voxel, glm::dvec3(0.0), last);
    const glm::ivec3 low = glm::min(glm::ivec3(voxel), glm::max(volume.size() - 2, glm::ivec3(0)));
    const glm::dvec3 t = voxel - glm::dvec3(low);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 up(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        const glm::ivec3 at = glm::min(low + up, volume.size() - 1);
        const glm::dvec3 weight = glm::mix(1.0 - t, t, glm::dvec3(up));
        sum += weight.x * weight.y * weight.z * volume.value(at.x, at.y, at.z);
    }
    return sum;
}

// Along a ray of unit direction, world mm, from its origin on; midpoint rule, `stepsPerVoxel` where it
// crosses voxels fastest.
inline double opticalDepth(const Volume& volume, const TransferFunction& function, const glm::dvec3& originMm,
                           const glm::dvec3& direction, int stepsPerVoxel = 20) {
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    const glm::dvec3 origin = transformPoint(voxelFromWorld, originMm);
    const glm::dvec3 along = transformVector(voxelFromWorld, direction);
    double from = 0.0;
    double to = 1e300;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = -0.5 - origin[axis];
        const double high = volume.size()[axis] - 0.5 - origin[axis];
        if (std::abs(along[axis]) < 1e-300) {
            if (low > 0.0 || high < 0.0) return 0.0;
            continue;
        }
        from = std::max(from, std::min(low / along[axis], high / along[axis]));
        to = std::min(to, std::max(low / along[axis], high / along[axis]));
    }
    if (to <= from) return 0.0;
    const double voxelsPerMm = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
    const int steps = std::max(10, static_cast<int>(std::ceil((to - from) * voxelsPerMm * stepsPerVoxel)));
    const double step = (to - from) / steps;
    double depth = 0.0;
    for (int i = 0; i < steps; ++i)
        depth +=
            extinctionPerMm(function, valueAt(volume, origin + along * (from + (i + 0.5) * step))) * step;
    return depth;
}

}  // namespace macula::scenes
