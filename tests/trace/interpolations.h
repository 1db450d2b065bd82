// Values between voxels, written anew in double: what filters of the tracer are held to.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "base/volume.h"
#include "trace/dense_march.h"

namespace macula::scenes {

inline double cubicBSpline(double t) {
    t = std::abs(t);
    if (t < 1.0) return 2.0 / 3.0 - t * t + 0.5 * t * t * t;
    return t < 2.0 ? (2.0 - t) * (2.0 - t) * (2.0 - t) / 6.0 : 0.0;
}

// Gradients are in units per voxel along the axes of the grid; places have integers at centres of voxels.
struct Trilinear {
    static double valueAt(const Volume& volume, const glm::dvec3& voxel) {
        return scenes::valueAt(volume, voxel);
    }
    // Central differences over a voxel to either side.
    static glm::dvec3 gradientAt(const Volume& volume, const glm::dvec3& voxel) {
        glm::dvec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0.0);
            step[axis] = 1.0;
            gradient[axis] = (valueAt(volume, voxel + step) - valueAt(volume, voxel - step)) / 2.0;
        }
        return gradient;
    }
};

struct Spline {
    // Beyond the outer voxels they go on.
    static double valueAt(const Volume& volume, const glm::dvec3& voxel) {
        const glm::ivec3 first = glm::ivec3(glm::floor(voxel)) - 1;
        double sum = 0.0;
        for (int n = 0; n < 64; ++n) {
            const glm::ivec3 at = first + glm::ivec3(n & 3, n >> 2 & 3, n >> 4);
            const glm::dvec3 away = voxel - glm::dvec3(at);
            const glm::ivec3 there = glm::clamp(at, glm::ivec3(0), volume.size() - 1);
            sum += cubicBSpline(away.x) * cubicBSpline(away.y) * cubicBSpline(away.z) *
                   volume.value(there.x, there.y, there.z);
        }
        return sum;
    }
    static glm::dvec3 gradientAt(const Volume& volume, const glm::dvec3& voxel) {
        constexpr double kStep = 1e-4;
        glm::dvec3 gradient;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0.0);
            step[axis] = kStep;
            gradient[axis] = (valueAt(volume, voxel + step) - valueAt(volume, voxel - step)) / (2.0 * kStep);
        }
        return gradient;
    }
};

}  // namespace macula::scenes
