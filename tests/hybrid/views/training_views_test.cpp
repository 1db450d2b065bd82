// Which views tell a model something, without a device.
#include "pipeline/hybrid/views/training_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pipeline/splat/draw/reference_rasterizer.h"
#include "pipeline/splat/train/reference_loss.h"

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

class PullOfViews : public ::testing::Test {
  protected:
    struct From {
        double radii = 3.0;
        double fovDeg = 20.0;
        glm::ivec2 sizePx{48};
    };

    double radiusMm() const { return 0.5 * seen_.diagonal(); }

    splat::RasterView view(const From& from) const {
        const Camera camera{.positionMm = seen_.centre() + glm::dvec3(0.0, -from.radii * radiusMm(), 0.0),
                            .targetMm = seen_.centre() + glm::dvec3(2.0, 0.0, 0.0),
                            .verticalFovDeg = from.fovDeg};
        return splat::rasterView(camera, from.sizePx, originMm_).value();
    }

    double weight(const From& from) const { return weightByArea(view(from), seen_, originMm_); }

    // The derivative of the weighed loss by the colour of a splat in the middle that is too dark.
    double pull(const From& from) const {
        splat::ReferenceSplats splat(1, 0);
        splat.position = {seen_.centre() - originMm_};
        splat.logScale = {glm::dvec3(std::log(0.1 * radiusMm()))};
        splat.rotation = {{1.0, 0.0, 0.0, 0.0}};
        splat.opacityLogit = {3.0};
        splat.dc = {glm::dvec3(0.2)};
        splat::ReferenceSplats brighter = splat;
        brighter.dc = {glm::dvec3(0.9)};
        const auto draw = [&](const splat::ReferenceSplats& of) {
            return rasterize(of, view(from), {}, splat::Precision::twofold);
        };
        const splat::RasterImage picture = draw(splat);
        const splat::ReferenceLoss loss = splat::referenceLoss(
            from.sizePx.x, from.sizePx.y, picture.rgba, draw(brighter).rgba, {},
            {.measure = splat::LossMeasure::absolute, .viewWeight = static_cast<float>(weight(from))});
        const splat::ReferenceSplats gradient = rasterizeBackward(
            splat, view(from), {}, picture, {.rgba = loss.gradient, .depth = {}}, splat::Precision::twofold);
        return -gradient.dc[0].g;
    }

    const Box seen_{.low = glm::dvec3(-30.0, 10.0, -5.0), .high = glm::dvec3(50.0, 40.0, 95.0)};
    const glm::dvec3 originMm_{1.0, 2.0, 3.0};
};

TEST_F(PullOfViews, IsAsHardFromNearAsFromFar) {
    const double usual = pull({});
    ASSERT_GT(usual, 1e-4);
    for (const From& from : {From{.radii = 1.3}, From{.radii = 5.5}, From{.fovDeg = 14.0},
                             From{.radii = 2.0, .sizePx = {96, 40}}, From{.radii = 0.7, .fovDeg = 60.0},
                             From{.sizePx = {160, 160}}})
        EXPECT_NEAR(pull(from), usual, 0.05 * usual) << from.radii << " R, " << from.fovDeg << " degrees";
}

TEST_F(PullOfViews, IsNeverWithoutEndNorNothing) {
    EXPECT_NEAR(weight({}), 1.0, 1e-6);
    EXPECT_EQ(weight({.radii = 1e5}), 4.0);
    EXPECT_EQ(weight({.radii = 1e-3}), weight({.radii = 0.5}));
    EXPECT_GT(weight({.radii = 1e-3}), 0.02);
    EXPECT_GT(weight({.radii = 1e-3, .fovDeg = 0.1}), 0.0);
    const Box point{.low = seen_.low, .high = seen_.low};
    EXPECT_EQ(weightByArea(view({}), point, originMm_), 1.0f);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()})
        EXPECT_EQ(weightByArea(view({}), {.low = glm::dvec3(bad), .high = seen_.high}, originMm_), 1.0f);
}

}  // namespace
}  // namespace macula::hybrid
