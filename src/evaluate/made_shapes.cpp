#include "evaluate/made_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/parallel.h"

namespace macula::evaluate {

namespace {

constexpr glm::ivec3 kShapeVoxels{64, 64, 64};
constexpr glm::ivec3 kDetailVoxels{48, 10, 48};
constexpr double kWaterHu = 40.0;
constexpr double kAirHu = -1000.0;
constexpr double kBlurMm = 0.6;  // standard deviation, as in a sharp CT reconstruction
constexpr double kDetailBlurMm = 0.4;
constexpr double kDetailDepthMm = 4.0;
constexpr double kAroundDetail = 100.0;
// No detail lies on a plane of voxels, nor half way between two.
constexpr double kOffsetMm = 0.25;

// A step blurred by a Gaussian, at a distance from the step.
double blurredStep(double distanceMm, double deviationMm) {
    return 0.5 * std::erfc(-distanceMm / (deviationMm * std::sqrt(2.0)));
}

// A bar of this thickness blurred by a Gaussian, at a distance from its middle.
double blurredBar(double distanceMm, double thicknessMm, double deviationMm) {
    return blurredStep(distanceMm + 0.5 * thicknessMm, deviationMm) -
           blurredStep(distanceMm - 0.5 * thicknessMm, deviationMm);
}

// A volume whose voxels hold value(centre in mm), rounded.
template <class Value>
Volume volumeOf(const glm::ivec3& size, Unit unit, double intercept, const Value& value) {
    const glm::dvec3 first = -0.5 * (glm::dvec3(size) - 1.0);
    std::vector<std::uint16_t> voxels(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    parallelFor(std::size_t(size.z), [&](std::size_t k) {
        std::size_t n = k * std::size_t(size.x) * std::size_t(size.y);
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i)
                voxels[n++] = static_cast<std::uint16_t>(
                    std::lround(value(first + glm::dvec3(i, j, double(k))) - intercept));
        }
    });
    glm::dmat4 worldFromVoxel(1.0);
    worldFromVoxel[3] = glm::dvec4(first, 1.0);
    auto volume = Volume::create({.size = size,
                                  .worldFromVoxel = worldFromVoxel,
                                  .unitsFromStored = {.slope = 1.0, .intercept = intercept},
                                  .unit = unit,
                                  .modality = unit == Unit::hounsfield ? "CT" : "OT",
                                  .padding = {},
                                  .provenance = {}},
                                 std::move(voxels));
    return std::move(volume).value();
}

double detailAt(Detail detail, const glm::dvec3& p) {
    const double x = p.x - kOffsetMm;
    const double across = std::clamp(blurredBar(p.y, kDetailDepthMm, kDetailBlurMm), 0.0, 1.0);
    if (detail == Detail::lines) {
        const double phase = x - kLinePeriodMm * std::round(x / kLinePeriodMm);
        double sum = 0.0;
        for (const int beside : {-1, 0, 1})
            sum += blurredBar(phase - beside * kLinePeriodMm, 0.5 * kLinePeriodMm, kDetailBlurMm);
        return 1000.0 * sum * across;
    }
    if (detail == Detail::fissure)
        return (kAroundDetail + 200.0 * blurredBar(x, 1.0, kDetailBlurMm)) * across;
    // A blurred cylinder is about the product of two blurred bars whose cross section has the same area.
    const double bar = std::sqrt(std::numbers::pi / 4.0);
    return kAroundDetail * across +
           900.0 * blurredBar(x, bar, kDetailBlurMm) * blurredBar(p.y - kOffsetMm, bar, kDetailBlurMm);
}

}  // namespace

std::string_view nameOf(Shape shape) {
    return shape == Shape::plane ? "plane" : shape == Shape::cylinder ? "cylinder" : "sphere";
}

std::string_view nameOf(Detail detail) {
    return detail == Detail::lines ? "lines" : detail == Detail::fissure ? "fissure" : "vessel";
}

double depthIn(Shape shape, const glm::dvec3& p) {
    if (shape == Shape::plane) {
        const glm::dvec3 outwards =
            glm::normalize(glm::dvec3(std::tan(glm::radians(8.0)), -1.0, std::tan(glm::radians(5.0))));
        return -glm::dot(outwards, p + glm::dvec3(0.0, 10.0, 0.0));
    }
    if (shape == Shape::cylinder) {
        const double tilt = glm::radians(10.0);
        const glm::dvec3 axis(std::sin(tilt), std::sin(tilt) * std::cos(tilt),
                              std::cos(tilt) * std::cos(tilt));
        return kShapeRadiusMm - glm::length(p - glm::dot(p, axis) * axis);
    }
    return kShapeRadiusMm - glm::length(p);
}

Volume make(Shape shape) {
    return volumeOf(kShapeVoxels, Unit::hounsfield, -1024.0, [shape](const glm::dvec3& p) {
        return kAirHu + (kWaterHu - kAirHu) * blurredStep(depthIn(shape, p), kBlurMm);
    });
}

Volume make(Detail detail) {
    return volumeOf(kDetailVoxels, Unit::raw, 0.0,
                    [detail](const glm::dvec3& p) { return detailAt(detail, p); });
}

}  // namespace macula::evaluate
