// The smooth filter against the spline that it is on average, in float and in double, without a GPU.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pipeline/trace/reference_tracer.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

double cubicBSpline(double t) {
    t = std::abs(t);
    if (t < 1.0) return 2.0 / 3.0 - t * t + 0.5 * t * t * t;
    return t < 2.0 ? (2.0 - t) * (2.0 - t) * (2.0 - t) / 6.0 : 0.0;
}
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
        const double expected = std::exp(-perMm * depthAlongY(cubicBSpline, x, z));
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

}  // namespace
}  // namespace macula::trace
