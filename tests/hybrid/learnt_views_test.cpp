// Which views tell a model something, without a device.
#include "pipeline/hybrid/learnt_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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
    EXPECT_EQ(weightBySamples(8.0), 1.0f);
    EXPECT_LT(weightBySamples(2.0), weightBySamples(4.0));
    EXPECT_NEAR(weightBySamples(2e-3), 2.0 * weightBySamples(1e-3), 1e-6);
    EXPECT_LE(weightBySamples(1e9), 2.0f);
    EXPECT_GT(weightBySamples(1.0), 0.1f);
}

// What a picture pulls at a splat with is in proportion to the part of it that the splat covers.
TEST(LearntViews, PullAsHardFromNearAsFromFar) {
    const Box seen{.low = glm::dvec3(-30.0, 10.0, -5.0), .high = glm::dvec3(50.0, 40.0, 95.0)};
    const glm::dvec3 originMm{1.0, 2.0, 3.0};
    const double radiusMm = 0.5 * seen.diagonal();
    struct From {
        double radii = 3.0;
        double fovDeg = 20.0;
        glm::ivec2 sizePx{64};
    };
    const auto view = [&](const From& from) {
        const Camera camera{.positionMm = seen.centre() + glm::dvec3(0.0, -from.radii * radiusMm, 0.0),
                            .targetMm = seen.centre() + glm::dvec3(20.0, 0.0, 0.0),
                            .verticalFovDeg = from.fovDeg};
        return splat::rasterView(camera, from.sizePx, originMm).value();
    };
    const auto weight = [&](const From& from) { return double(weightByArea(view(from), seen, originMm)); };
    // Of a picture, of what is 1 mm2 where the centre is.
    const auto part = [&](const From& from) {
        const splat::RasterView raster = view(from);
        const double distanceMm = from.radii * radiusMm;
        const glm::dvec2 mm = glm::dvec2(raster.sizePx) / raster.focalPx * distanceMm;
        return 1.0 / (mm.x * mm.y);
    };
    EXPECT_NEAR(weight({}), 1.0, 1e-6);
    EXPECT_NEAR(weight({.sizePx = {640, 640}}), 1.0, 1e-6) << "pixels are no reason";
    for (const From& from : {From{.radii = 1.3}, From{.radii = 5.5}, From{.fovDeg = 5.0},
                             From{.radii = 2.0, .sizePx = {96, 40}}, From{.radii = 0.7, .fovDeg = 60.0}})
        EXPECT_NEAR(weight(from) * part(from), part({}), 1e-6 * part({})) << from.radii << " " << from.fovDeg;
    // Never without end, and never nothing.
    EXPECT_EQ(weight({.radii = 1e5}), 4.0);
    EXPECT_EQ(weight({.radii = 0.0}), weight({.radii = 0.5}));
    EXPECT_GT(weight({.radii = 0.0}), 0.02);
    EXPECT_GT(weight({.radii = 0.0, .fovDeg = 0.1}), 0.0);
    const Box point{.low = seen.low, .high = seen.low};
    EXPECT_EQ(weightByArea(view({}), point, originMm), 1.0f);
    const Box unusable{.low = glm::dvec3(std::numeric_limits<double>::quiet_NaN()), .high = seen.high};
    EXPECT_EQ(weightByArea(view({}), unusable, originMm), 1.0f);
}

}  // namespace
}  // namespace macula::hybrid
