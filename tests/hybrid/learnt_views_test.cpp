// Which views tell a model something, without a device.
#include "pipeline/hybrid/learnt_views.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula::hybrid {
namespace {

splat::RasterView seenFrom(const glm::dvec3& eyeMm, const glm::dvec3& targetMm) {
    return splat::rasterView({.positionMm = eyeMm, .targetMm = targetMm}, {32, 32}, {1.0, 2.0, 3.0}).value();
}

TEST(LearntViews, AreNewFromElsewhereOrAnotherDirection) {
    const glm::dvec3 eye{0, -500, 0};
    const splat::RasterView known = seenFrom(eye, {0, 0, 0});
    const auto isNew = [&](const splat::RasterView& view, const AdmissionOptions& options = {}) {
        EXPECT_EQ(isSamePose(view, known, 200.0, options), isSamePose(known, view, 200.0, options));
        return !isSamePose(view, known, 200.0, options);
    };
    EXPECT_FALSE(isNew(known));
    EXPECT_TRUE(isNew(seenFrom({0, 500, 0}, {0, 0, 0})));
    // 0.05 of 200 mm; moved along with what it looks at, so that the direction stays.
    EXPECT_FALSE(isNew(seenFrom(eye + glm::dvec3(9.9, 0, 0), {9.9, 0, 0})));
    EXPECT_TRUE(isNew(seenFrom(eye + glm::dvec3(10.1, 0, 0), {10.1, 0, 0})));
    EXPECT_FALSE(isNew(seenFrom(eye + glm::dvec3(10.1, 0, 0), {10.1, 0, 0}), {.newDistanceRadii = 0.06}));
    const auto turned = [&](double degrees) {
        return seenFrom(eye, {500 * std::tan(glm::radians(degrees)), 0, 0});
    };
    EXPECT_FALSE(isNew(turned(4.9)));
    EXPECT_TRUE(isNew(turned(5.1)));
    EXPECT_FALSE(isNew(turned(5.1), {.newAngleDeg = 6.0}));
}

TEST(LearntViews, CountMoreWithMoreSamplesWithinReason) {
    EXPECT_EQ(weightOf(8.0), 1.0f);
    EXPECT_LT(weightOf(2.0), weightOf(4.0));
    EXPECT_NEAR(weightOf(2e-3), 2.0 * weightOf(1e-3), 1e-6);
    EXPECT_LE(weightOf(1e9), 2.0f);
    EXPECT_GT(weightOf(1.0), 0.1f);
}

}  // namespace
}  // namespace macula::hybrid
