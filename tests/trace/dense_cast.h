// The slow truth of ray casting: emission and absorption, and projections, along a ray, in double, from the
// volume, the transfer function and the clip themselves.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/clip.h"
#include "trace/dense_march.h"

namespace macula::scenes {

struct DenseRay {
    glm::dvec4 matter{0.0};  // linear premultiplied colour, and 1 - transmittance
    bool met = false;        // any value
    double largest = 0.0;
    double smallest = 0.0;
    double mean = 0.0;
};

inline double linearOf(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// Length of the gradient of values per voxel of mean edge, as VTK defines it: central differences over a
// voxel to either side along the axes of the grid, each per mm, times the mean spacing. For grids with
// orthogonal axes.
inline double gradientPerVoxel(const Volume& volume, const glm::dvec3& voxel) {
    const glm::dvec3 spacing = volume.spacingMm();
    glm::dvec3 perMm(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0.0);
        step[axis] = 1.0;
        perMm[axis] = (valueAt(volume, voxel + step) - valueAt(volume, voxel - step)) / (2.0 * spacing[axis]);
    }
    return glm::length(perMm) * (spacing.x + spacing.y + spacing.z) / 3.0;
}

// From `originMm` on; midpoints of steps, `stepsPerVoxel` of them where the ray crosses voxels fastest.
inline DenseRay denseCast(const Volume& volume, const TransferFunction& function, const Clip& clip,
                          const glm::dvec3& originMm, const glm::dvec3& direction, int stepsPerVoxel = 20) {
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    const glm::dvec3 origin = transformPoint(voxelFromWorld, originMm);
    const glm::dvec3 along = transformVector(voxelFromWorld, direction);
    double from = 0.0;
    double to = 1e300;
    for (int axis = 0; axis < 3; ++axis) {
        const double slope = std::abs(along[axis]) < 1e-12 ? 1e-12 : along[axis];
        const double a = (-0.5 - origin[axis]) / slope;
        const double b = (volume.size()[axis] - 0.5 - origin[axis]) / slope;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    DenseRay ray;
    if (to <= from) return ray;
    const bool gradients = usesGradientOpacity(function);
    const double voxelsPerMm = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
    const int steps = std::max(10, static_cast<int>(std::ceil((to - from) * voxelsPerMm * stepsPerVoxel)));
    const double step = (to - from) / steps;
    double transmittance = 1.0;
    double sum = 0.0;
    int counted = 0;
    for (int i = 0; i < steps; ++i) {
        const double at = from + (i + 0.5) * step;
        if (!shows(clip, originMm + direction * at)) continue;
        const glm::dvec3 voxel = origin + along * at;
        const double value = valueAt(volume, voxel);
        ray.largest = ray.met ? std::max(ray.largest, value) : value;
        ray.smallest = ray.met ? std::min(ray.smallest, value) : value;
        ray.met = true;
        sum += value;
        ++counted;
        if (transmittance < 1e-6 || opacityAt(function, value) <= 0.0) continue;
        double opacity = std::min(opacityAt(function, value), 0.999);
        if (gradients) opacity *= gradientOpacityAt(function, gradientPerVoxel(volume, voxel));
        const double through =
            std::exp(std::log1p(-opacity) / function.unitDistanceMm * function.density * step);
        const glm::dvec3 encoded = colourAt(function, value);
        const glm::dvec3 colour =
            function.albedo * glm::dvec3(linearOf(encoded.r), linearOf(encoded.g), linearOf(encoded.b));
        ray.matter += glm::dvec4(colour, 1.0) * transmittance * (1.0 - through);
        transmittance *= through;
    }
    if (counted > 0) ray.mean = sum / counted;
    return ray;
}

// Through a point of the picture, in pixels from its top left corner.
inline glm::dvec3 eyeRay(const trace::View& view, double x, double y) {
    const CameraBasis eye = *basis(view.camera);
    const double half = std::tan(glm::radians(view.camera.verticalFovDeg) / 2.0);
    return glm::normalize(eye.forward +
                          eye.right * (half * view.width / view.height * (2.0 * x / view.width - 1.0)) +
                          eye.up * (half * (1.0 - 2.0 * y / view.height)));
}

}  // namespace macula::scenes
