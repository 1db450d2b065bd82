// The slow truth of ray casting: emission and absorption, and projections, along a ray, in double, from the
// volume, the transfer function and the clip themselves.
#pragma once

#include <glm/glm.hpp>
#include <type_traits>

#include "base/camera.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/clip.h"
#include "trace/dense_march.h"
#include "trace/interpolations.h"

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

// In units per mm, world. For grids with orthogonal axes.
template <class Interpolation>
glm::dvec3 gradientPerMm(const Volume& volume, const glm::dvec3& voxel) {
    const glm::dmat3 voxelFromMm(glm::inverse(volume.worldFromVoxel()));
    return glm::transpose(voxelFromMm) * Interpolation::gradientAt(volume, voxel);
}

// The part of matter that is steep: between voxels trilinear, but by the gradient of a spline, where there is
// one.
template <class Interpolation>
double steepPart(const Volume& volume, const TransferFunction& function, const glm::dvec3& voxel) {
    const auto partAt = [&](const glm::dvec3& at) {
        const double length = glm::length(gradientPerMm<Interpolation>(volume, at));
        const double half = function.steep.gradientPerMm;
        return length * length / (length * length + half * half);
    };
    if constexpr (!std::is_same_v<Interpolation, Trilinear>) return partAt(voxel);
    const glm::dvec3 last(volume.size() - 1);
    const glm::dvec3 inside = glm::clamp(voxel, glm::dvec3(0.0), last);
    const glm::dvec3 low = glm::floor(inside);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 up(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        const glm::dvec3 weight = glm::mix(1.0 - (inside - low), inside - low, up);
        sum += weight.x * weight.y * weight.z * partAt(glm::min(low + up, last));
    }
    return sum;
}

// Linear colour times extinction per mm, and the extinction, by one pair of curves.
inline glm::dvec4 denseMatter(const TransferFunction& function, double value, double gradientOpacity) {
    const double opacity = gradientOpacity * std::min(opacityAt(function, value), 0.999);
    const glm::dvec3 encoded = colourAt(function, value);
    const glm::dvec3 colour =
        function.albedo * glm::dvec3(linearOf(encoded.r), linearOf(encoded.g), linearOf(encoded.b));
    return glm::dvec4(colour, 1.0) * (-std::log1p(-opacity) / function.unitDistanceMm * function.density);
}

// From `originMm` on; midpoints of steps, `stepsPerVoxel` of them where the ray crosses voxels fastest.
// With a headlight when `isLit`.
template <class Interpolation = Trilinear>
DenseRay denseCast(const Volume& volume, const TransferFunction& function, const Clip& clip,
                   const glm::dvec3& originMm, const glm::dvec3& direction, int stepsPerVoxel = 20,
                   bool isLit = false) {
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
    const bool isSteep = usesSteepCurves(function);
    const TransferFunction steep = withCurvesSwapped(function);
    const glm::dvec3 spacing = volume.spacingMm();
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
        const double value = Interpolation::valueAt(volume, voxel);
        ray.largest = ray.met ? std::max(ray.largest, value) : value;
        ray.smallest = ray.met ? std::min(ray.smallest, value) : value;
        ray.met = true;
        sum += value;
        ++counted;
        if (transmittance < 1e-6) continue;
        if (opacityAt(function, value) <= 0.0 && !(isSteep && opacityAt(steep, value) > 0.0)) continue;
        glm::dvec3 gradient(0.0);
        if (gradients || isLit) gradient = gradientPerMm<Interpolation>(volume, voxel);
        // Per voxel of mean edge, as VTK defines it.
        const double left = gradients
                                ? gradientOpacityAt(function, glm::length(gradient) *
                                                                  (spacing.x + spacing.y + spacing.z) / 3.0)
                                : 1.0;
        glm::dvec4 matter = denseMatter(function, value, left);
        if (isSteep)
            matter = glm::mix(matter, denseMatter(steep, value, left),
                              steepPart<Interpolation>(volume, function, voxel));
        if (!(matter.a > 0.0)) continue;
        const double through = std::exp(-matter.a * step);
        const glm::dvec3 colour = glm::dvec3(matter) / matter.a;
        double light = 1.0;
        if (isLit) {
            const double length = glm::length(gradient);
            const double cosine = length > 0.0 ? std::abs(glm::dot(gradient, direction)) / length : 1.0;
            light = function.lighting.ambient + function.lighting.diffuse * cosine;
        }
        ray.matter += glm::dvec4(light * colour, 1.0) * transmittance * (1.0 - through);
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
