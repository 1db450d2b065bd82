// The smooth filter against the spline that it is on average, in float and in double, without a GPU.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pipeline/trace/reference_tracer.h"
#include "trace/interpolations.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

double hat(double t) {
    return std::max(1.0 - std::abs(t), 0.0);
}

constexpr glm::ivec3 kSize{13, 24, 14};

// Of voxels that are 0 or 1, beyond a rim that is 0.
bool isSet(int i, int j, int k) {
    const glm::ivec3 at(i, j, k);
    if (glm::any(glm::lessThan(at, glm::ivec3(3))) || glm::any(glm::greaterThan(at, kSize - 4))) return false;
    return std::mt19937(static_cast<std::uint32_t>(i + 100 * j + 10000 * k))() % 2 == 0;
}

// The sum along y of what voxels weigh at x and z, in voxel coordinates with integers at centres.
double depthAlongY(const auto& weight, double x, double z) {
    double depth = 0.0;
    for (int k = 0; k < kSize.z; ++k) {
        for (int j = 0; j < kSize.y; ++j) {
            for (int i = 0; i < kSize.x; ++i)
                depth += isSet(i, j, k) ? weight(x - i) * weight(z - k) : 0.0;  // over y the weight is 1
        }
    }
    return depth;
}

TEST(SmoothFilter, IsACubicBSplineOnAverage) {
    const auto volume = scenes::volumeOf(
        kSize, glm::dmat4(1.0), [](int i, int j, int k) { return std::uint16_t(isSet(i, j, k) ? 1 : 0); });
    // Extinction is linear between two neighbouring stored values.
    const TransferFunction curve = scenes::homogeneous(0.15);
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume, reachOf(Filter::smooth)), curve);
    const auto params =
        makeTraceParams(*volume, medium, Environment::constant(glm::vec3(1.0f)), {}, {.seed = 11});
    const ReferenceTracer tracer(*volume, medium, Environment::constant(glm::vec3(1.0f)));
    const double perMm = extinctionPerMm(curve, 1.0);
    constexpr std::uint32_t kSamples = 200'000;
    for (const auto& [x, z] :
         {std::pair(6.0, 7.0), std::pair(5.3, 6.4), std::pair(7.5, 6.5), std::pair(4.9, 8.1)}) {
        const double expected = std::exp(-perMm * depthAlongY(scenes::cubicBSpline, x, z));
        const double interpolated = std::exp(-perMm * depthAlongY(hat, x, z));
        for (const Precision precision : {Precision::single, Precision::twofold}) {
            // Rays are given with integers at the faces of voxels.
            const auto moments = tracer.transmittance(*params, Filter::smooth, precision,
                                                      {x + 0.5, -1.0, z + 0.5}, {0, 1, 0}, kSamples);
            const double mean = moments.sum / kSamples;
            const double error = std::sqrt((moments.sumOfSquares / kSamples - mean * mean) / kSamples);
            EXPECT_NEAR(mean, expected, 4.5 * error) << x << " " << z;
            if (x == 6.0) {
                EXPECT_GT(std::abs(mean - interpolated), 9.0 * error) << "the test must tell them apart";
            }
        }
    }
}

// A blurred ball, whose normals are known: on average those of paths point along the radius.
TEST(SmoothFilter, NormalsOfABallAreWithinHalfADegree) {
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
