// Values between voxels, written anew in double: what filters of the tracer are held to.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

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

// Mitchell and Netravali, "Reconstruction filters in computer graphics" (1988), with B = C = 1/3.
inline double mitchellNetravali(double t) {
    t = std::abs(t);
    if (t < 1.0) return (7.0 * t * t * t - 12.0 * t * t + 16.0 / 3.0) / 6.0;
    return t < 2.0 ? (-7.0 / 3.0 * t * t * t + 12.0 * t * t - 20.0 * t + 32.0 / 3.0) / 6.0 : 0.0;
}

template <double (*kWeight)(double)>
struct SplineOf {
    // Beyond the outer voxels they go on. Held to the values of the voxels.
    static double valueAt(const Volume& volume, const glm::dvec3& voxel) {
        const glm::ivec3 first = glm::ivec3(glm::floor(voxel)) - 1;
        double sum = 0.0;
        double least = std::numeric_limits<double>::max();
        double most = std::numeric_limits<double>::lowest();
        for (int n = 0; n < 64; ++n) {
            const glm::ivec3 at = first + glm::ivec3(n & 3, n >> 2 & 3, n >> 4);
            const glm::dvec3 away = voxel - glm::dvec3(at);
            const glm::ivec3 there = glm::clamp(at, glm::ivec3(0), volume.size() - 1);
            const double value = volume.value(there.x, there.y, there.z);
            sum += kWeight(away.x) * kWeight(away.y) * kWeight(away.z) * value;
            least = std::min(least, value);
            most = std::max(most, value);
        }
        return std::clamp(sum, least, most);
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
using Spline = SplineOf<cubicBSpline>;
using SharpSpline = SplineOf<mitchellNetravali>;

}  // namespace macula::scenes
