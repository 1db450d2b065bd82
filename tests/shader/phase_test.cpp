#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "shader/shader_lib.h"
#include "shader/statistics.h"

namespace macula {
namespace {

using Lib = ShaderLibTwofold;
constexpr double kPi = std::numbers::pi;

TEST(Phase, IsNormalisedOverTheSphere) {
    Lib lib;
    for (const double g : {-0.9, -0.3, 0.0, 0.5, 0.95}) {
        double sum = 0.0;
        constexpr int kSteps = 200000;
        for (int i = 0; i < kSteps; ++i) {
            const double cosine = -1.0 + 2.0 * (i + 0.5) / kSteps;
            sum += lib.phaseHenyeyGreenstein(cosine, g) * 2.0 * kPi * (2.0 / kSteps);
        }
        EXPECT_NEAR(sum, 1.0, 1e-4) << g;
    }
}

TEST(Phase, SamplesFollowThePhaseFunction) {
    Lib lib;
    auto rng = lib.makeRng(1, 1, 1, 1);
    const Lib::vec3 forward = glm::normalize(Lib::vec3(0.3, -0.8, -0.52));
    constexpr int kCells = 64;
    constexpr int kDraws = 400000;
    for (const double g : {-0.6, 0.0, 0.0005, 0.05, 0.4, 0.9}) {
        std::vector<double> cells(kCells, 0.0);
        std::vector<double> expected(kCells, 0.0);
        double meanCosine = 0.0;
        for (int i = 0; i < kDraws; ++i) {
            const double u = lib.random01(rng);
            const Lib::vec3 direction = lib.samplePhase(forward, g, {u, lib.random01(rng)});
            ASSERT_NEAR(glm::length(direction), 1.0, 1e-12);
            const double cosine = glm::dot(direction, forward);
            meanCosine += cosine / kDraws;
            ++cells[std::size_t(std::min(int((cosine + 1.0) / 2.0 * kCells), kCells - 1))];
        }
        constexpr int kSub = 200;
        for (int c = 0; c < kCells; ++c) {
            for (int s = 0; s < kSub; ++s) {
                const double cosine = -1.0 + 2.0 * (c + (s + 0.5) / kSub) / kCells;
                expected[std::size_t(c)] +=
                    lib.phaseHenyeyGreenstein(cosine, g) * 2.0 * kPi * 2.0 / kCells / kSub * kDraws;
            }
        }
        EXPECT_LT(std::abs(statistics::chiSquareDeviate(cells, expected)), statistics::kDeviateLimit) << g;
        // The definition of g; a cosine has a variance of at most a third.
        EXPECT_NEAR(meanCosine, g, statistics::kDeviateLimit * std::sqrt(1.0 / 3.0 / kDraws));
    }
}

TEST(Phase, FrameIsOrthonormalInEveryDirectionAlsoAtThePoles) {
    ShaderLibSingle lib;
    using vec3 = ShaderLibSingle::vec3;
    for (const vec3 n :
         {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0), vec3(0, -1, 0), glm::normalize(vec3(1e-4f, 0, -1))}) {
        vec3 a;
        vec3 b;
        lib.orthonormalFrame(n, a, b);
        EXPECT_NEAR(glm::dot(a, b), 0.0, 1e-6);
        EXPECT_NEAR(glm::dot(a, n), 0.0, 1e-6);
        EXPECT_NEAR(glm::length(a), 1.0, 1e-6);
        EXPECT_NEAR(glm::length(b), 1.0, 1e-6);
    }
}

}  // namespace
}  // namespace macula
