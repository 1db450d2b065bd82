// Values between voxels, written anew in double: what filters of the tracer are held to.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtx/component_wise.hpp>

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
    // Within the range of the values.
    static double of(const glm::dvec4& values, const glm::dvec4& weights) {
        return std::clamp(glm::dot(values, weights), glm::compMin(values), glm::compMax(values));
    }
    // Along x, then y, then z. Beyond the outer voxels they go on.
    static double valueAt(const Volume& volume, const glm::dvec3& voxel) {
        const glm::ivec3 first = glm::ivec3(glm::floor(voxel)) - 1;
        const auto weights = [&](int axis) {
            const double at = voxel[axis] - first[axis];
            return glm::dvec4(kWeight(at), kWeight(at - 1.0), kWeight(at - 2.0), kWeight(at - 3.0));
        };
        const auto valueOf = [&](int i, int j, int k) {
            const glm::ivec3 at = glm::clamp(first + glm::ivec3(i, j, k), glm::ivec3(0), volume.size() - 1);
            return double(volume.value(at.x, at.y, at.z));
        };
        glm::dvec4 layers;
        for (int k = 0; k < 4; ++k) {
            glm::dvec4 rows;
            for (int j = 0; j < 4; ++j) {
                const glm::dvec4 row(valueOf(0, j, k), valueOf(1, j, k), valueOf(2, j, k), valueOf(3, j, k));
                rows[j] = of(row, weights(0));
            }
            layers[k] = of(rows, weights(1));
        }
        return of(layers, weights(2));
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
