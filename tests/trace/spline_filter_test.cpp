// The filters that are splines, against those written anew, in float and in double, without a GPU.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "pipeline/trace/reference_tracer.h"
#include "trace/interpolations.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

constexpr glm::ivec3 kSize{13, 24, 14};
constexpr double kHigh = 1000.0;

std::shared_ptr<const Volume> speckled() {
    return scenes::volumeOf(kSize, glm::dmat4(1.0), [](int i, int j, int k) {
        const auto seed = static_cast<std::uint32_t>(i + 100 * j + 10000 * k);
        return std::uint16_t(std::mt19937(seed)() % 2 == 0 ? kHigh : 0.0);
    });
}

// Of a steep curve along y, in mm; x and z in voxels with integers at centres.
template <class Interpolation>
double depthAlongY(const Volume& volume, const TransferFunction& curve, double x, double z) {
    constexpr double kStepMm = 0.005;
    double depth = 0.0;
    for (double y = -0.5 + 0.5 * kStepMm; y < kSize.y - 0.5; y += kStepMm)
        depth += extinctionPerMm(curve, Interpolation::valueAt(volume, {x, y, z})) * kStepMm;
    return depth;
}

// The value comes before the curve: an average of what the curve makes of other values is something else.
TEST(SplineFilter, PathsMeetWhatTheCurveMakesOfTheSpline) {
    const auto volume = speckled();
    TransferFunction curve = scenes::homogeneous(0.15);
    curve.opacity = {{0.35 * kHigh, 0.0}, {0.65 * kHigh, 0.15}};
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume, reachOf(Filter::smooth)), curve);
    const auto params = makeTraceParams(*volume, medium, sky, {}, {.seed = 11});
    const ReferenceTracer tracer(*volume, medium, sky);
    constexpr std::uint32_t kSamples = 200'000;
    std::array<double, 2> furthest{};
    for (const auto& [x, z] : {std::pair(6.0, 7.0), std::pair(5.3, 6.4), std::pair(7.5, 6.5),
                               std::pair(4.9, 8.1), std::pair(-0.3, 0.2), std::pair(12.3, 13.4)}) {
        const double trilinear = std::exp(-depthAlongY<scenes::Trilinear>(*volume, curve, x, z));
        const std::array expected{std::exp(-depthAlongY<scenes::Spline>(*volume, curve, x, z)),
                                  std::exp(-depthAlongY<scenes::SharpSpline>(*volume, curve, x, z))};
        for (const Precision precision : {Precision::single, Precision::twofold}) {
            for (const Filter filter : {Filter::smooth, Filter::sharp}) {
                // Rays are given with integers at the faces of voxels.
                const auto moments = tracer.transmittance(*params, filter, precision,
                                                          {x + 0.5, -1.0, z + 0.5}, {0, 1, 0}, kSamples);
                const double mean = moments.sum / kSamples;
                const double error = std::sqrt((moments.sumOfSquares / kSamples - mean * mean) / kSamples);
                const std::size_t n = filter == Filter::smooth ? 0 : 1;
                const double truth = expected.at(n);
                EXPECT_NEAR(mean, truth, 4.5 * error) << nameOf(filter) << " " << x << " " << z;
                const double other =
                    std::min(std::abs(truth - trilinear), std::abs(truth - expected.at(1 - n)));
                furthest.at(n) = std::max(furthest.at(n), other / error);
            }
        }
    }
    EXPECT_GT(furthest[0], 20.0) << "the test must tell them apart";
    EXPECT_GT(furthest[1], 10.0) << "the test must tell them apart";
}

// Voxels of both ends of the scale, side by side: where the sharp spline goes beyond them nothing is above
// the bound.
TEST(SplineFilter, WhatTheSharpSplineOvershootsIsNotAboveTheBound) {
    const auto volume = scenes::volumeOf({16, 16, 16}, glm::dmat4(1.0), [](int i, int j, int k) {
        if (k == 15 && i == 15) return std::uint16_t(j % 2 == 0 ? 0 : 1000);  // so that tables reach there
        return std::uint16_t((i / 2 + j / 2 + k / 2) % 2 == 0 ? 600 : 400);
    });
    TransferFunction curve = scenes::homogeneous(0.1);
    // Nothing between the voxels' values, and much beside them.
    curve.opacity = {{399.0, 0.5}, {400.0, 0.01}, {600.0, 0.01}, {601.0, 0.5}};
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume, reachOf(Filter::sharp)), curve);
    const auto params = makeTraceParams(*volume, medium, sky, {}, {.seed = 3});
    const ReferenceTracer tracer(*volume, medium, sky);
    const double perMm = extinctionPerMm(curve, 500.0);
    constexpr std::uint32_t kSamples = 100'000;
    for (const double x : {6.5, 8.0, 9.2}) {
        const auto moments = tracer.transmittance(*params, Filter::sharp, Precision::twofold, {x, -1.0, 7.7},
                                                  {0, 1, 0}, kSamples);
        const double mean = moments.sum / kSamples;
        const double error = std::sqrt((moments.sumOfSquares / kSamples - mean * mean) / kSamples);
        EXPECT_NEAR(mean, std::exp(-16.0 * perMm), 4.5 * error) << x;
    }
}

// A voxel that lies in reach on one side of a plane only lets nothing overshoot there that is held on the
// other.
TEST(SplineFilter, WhereTheSharpSplineIsHeldItDoesNotJump) {
    const auto volume = scenes::volumeOf({9, 24, 9}, glm::dmat4(1.0), [](int i, int j, int k) {
        if (i == 6 && k == 4) return std::uint16_t(3000);
        return std::uint16_t(j % 4 < 2 ? 1000 : 0);
    });
    TransferFunction curve = scenes::homogeneous(0.1);
    curve.opacity = {{0.0, 0.01}, {1000.0, 0.01}, {1040.0, 0.5}};
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume, reachOf(Filter::sharp)), curve);
    const auto params = makeTraceParams(*volume, medium, sky, {}, {.seed = 3});
    const ReferenceTracer tracer(*volume, medium, sky);
    constexpr std::uint32_t kSamples = 10'000;
    const auto through = [&](double x) {
        return tracer
                   .transmittance(*params, Filter::sharp, Precision::twofold, {x + 0.5, -1.0, 5.0}, {0, 1, 0},
                                  kSamples)
                   .sum /
               kSamples;
    };
    EXPECT_NEAR(through(4.0 - 1e-7), through(4.0 + 1e-7), 1e-3);
}

// A blurred ball, whose normals are known: on average those of paths point along the radius.
TEST(SplineFilter, NormalsOfABallAreWithinHalfADegree) {
    constexpr double kRadius = 12.0;
    const auto volume = scenes::volumeOf({32, 32, 32}, glm::dmat4(1.0), [](int i, int j, int k) {
        const double depth = kRadius - glm::length(glm::dvec3(i, j, k) - 15.5);
        return std::uint16_t(std::lround(500.0 * std::erfc(-depth / (0.6 * std::sqrt(2.0)))));
    });
    const TransferFunction curve = scenes::homogeneous(0.15);
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume, reachOf(Filter::smooth)), curve);
    const auto params =
        makeTraceParams(*volume, medium, Environment::constant(glm::vec3(1.0f)), {}, {.seed = 5});
    const ReferenceTracer tracer(*volume, medium, Environment::constant(glm::vec3(1.0f)));
    std::mt19937 engine(4);
    std::normal_distribution<double> normal;
    double worst = 0.0;
    double worstTrilinear = 0.0;
    const auto turned = [&](Filter filter, const glm::dvec3& outwards, std::uint32_t samples) {
        // Integers at faces; the ball's centre lies between voxels.
        const auto gradient = tracer.meanGradient(*params, filter, Precision::twofold,
                                                  glm::dvec3(16.0) + kRadius * outwards, samples);
        return glm::degrees(std::acos(std::min(glm::dot(-glm::normalize(gradient), outwards), 1.0)));
    };
    for (int n = 0; n < 60; ++n) {
        const glm::dvec3 outwards =
            glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine)));
        worst = std::max(worst, turned(Filter::smooth, outwards, 80'000));
        worstTrilinear = std::max(worstTrilinear, turned(Filter::trilinear, outwards, 20'000));
    }
    std::printf("  the worst of 60 normals: smooth %.3f degrees, trilinear %.3f\n", worst, worstTrilinear);
    EXPECT_LT(worst, 0.5);
    EXPECT_GT(worstTrilinear, worst);
}

}  // namespace
}  // namespace macula::trace
