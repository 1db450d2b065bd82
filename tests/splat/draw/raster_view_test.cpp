#include "pipeline/splat/draw/raster_view.h"

#include <cmath>
#include <limits>

#include "splat/draw/reference_scenes.h"

namespace macula::splat {
namespace {

RasterImage picture(const glm::dvec3& positionMm, ViewDirection from) {
    const Box box{glm::dvec3(-100), glm::dvec3(100)};
    const RasterView view = rasterView(frameBox(box, from, 30, 1.0), {40, 40}, glm::dvec3(0)).value();
    ReferenceSplats splats = oneSplat(10);
    splats.position[0] = positionMm;
    return rasterize(splats, view, {}, Precision::twofold);
}

// Where the coverage is, from the middle: to the right and down positive.
glm::dvec2 centroid(const RasterImage& image) {
    glm::dvec2 sum(0.0);
    for (int row = 0; row < image.sizePx.y; ++row) {
        for (int column = 0; column < image.sizePx.x; ++column)
            sum +=
                at(image, column, row).a * (glm::dvec2(column, row) + 0.5 - 0.5 * glm::dvec2(image.sizePx));
    }
    return sum / coverageSum(image);
}

// LPS: +x is the patient's left, +y posterior, +z superior. As in every radiological display, from the front
// the patient's left is on the right.
TEST(RasterView, LeftIsLeftAndUpIsUp) {
    const glm::dvec3 left(60, 0, 0);
    const glm::dvec3 anterior(0, -60, 0);
    const glm::dvec3 superior(0, 0, 60);
    EXPECT_GT(centroid(picture(left, ViewDirection::anterior)).x, 4.0);
    EXPECT_LT(centroid(picture(left, ViewDirection::posterior)).x, -4.0);
    EXPECT_LT(centroid(picture(anterior, ViewDirection::left)).x, -4.0);
    EXPECT_GT(centroid(picture(anterior, ViewDirection::right)).x, 4.0);
    EXPECT_LT(centroid(picture(superior, ViewDirection::anterior)).y, -4.0);
    EXPECT_LT(centroid(picture(superior, ViewDirection::left)).y, -4.0);
    EXPECT_LT(centroid(picture(anterior, ViewDirection::superior)).y, -4.0);
    EXPECT_NEAR(centroid(picture(superior, ViewDirection::anterior)).x, 0.0, 1e-6);
    EXPECT_NEAR(centroid(picture(left, ViewDirection::anterior)).y, 0.0, 1e-6);
}

// As many pixels per mm at every depth, and what is left stays left.
TEST(RasterView, WithParallelRaysDepthChangesNothing) {
    const Box box{glm::dvec3(-100), glm::dvec3(100)};
    for (const ViewDirection from : {ViewDirection::anterior, ViewDirection::left, ViewDirection::superior}) {
        const Camera camera = frameInParallel(cornersOf(box), standardBasis(from), 30, 1.0);
        const RasterView view = rasterView(camera, {40, 40}, glm::dvec3(0)).value();
        ASSERT_TRUE(view.isParallel);
        const double pxPerMm = 40.0 / camera.parallelHeightMm;
        const glm::dmat3 worldFromCamera = glm::transpose(view.cameraFromWorld);
        for (const double depth : {-80.0, 0.0, 80.0}) {
            ReferenceSplats splats = oneSplat(10);
            splats.position[0] = worldFromCamera * glm::dvec3(40, -20, depth);
            const glm::dvec2 middle = centroid(rasterize(splats, view, {}, Precision::twofold));
            EXPECT_NEAR(middle.x, 40 * pxPerMm, 0.05) << depth;
            EXPECT_NEAR(middle.y, -20 * pxPerMm, 0.05) << depth;
        }
    }
    // The patient's left is on the right from the front.
    const Camera front = frameInParallel(cornersOf(box), standardBasis(ViewDirection::anterior), 30, 1.0);
    ReferenceSplats left = oneSplat(10);
    left.position[0] = {60, 0, 0};
    EXPECT_GT(
        centroid(rasterize(left, rasterView(front, {40, 40}, glm::dvec3(0)).value(), {}, Precision::twofold))
            .x,
        4.0);
    // Few pixels for many mm are a picture too.
    Camera wide = front;
    wide.parallelHeightMm = 1e5;
    EXPECT_TRUE(validate(rasterView(wide, {40, 40}, glm::dvec3(0)).value()).ok());
}

// Beyond 1.3 times the field of view splats are projected as on its edge: as the renderers do that models are
// trained with (Kerbl et al. 2023).
TEST(RasterView, SlopesEndAtThirteenTenthsOfTheField) {
    const Camera camera{.positionMm = {0, -400, 0}, .verticalFovDeg = 50};
    const RasterView view = rasterView(camera, {60, 40}, glm::dvec3(0)).value();
    const double tanHalf = std::tan(glm::radians(25.0));
    const glm::dvec2 most(1.3 * 1.5 * tanHalf, 1.3 * tanHalf);
    EXPECT_LT(glm::distance(highestSlope(view), most), 1e-12);
    EXPECT_LT(glm::distance(lowestSlope(view), -most), 1e-12);
}

TEST(RasterView, PicksThePixelThatAPinholeDoes) {
    const Camera camera{
        .positionMm = {130, -400, 70}, .targetMm = {10, 20, 30}, .up = {0.1, 0, 1}, .verticalFovDeg = 50};
    const glm::dvec3 originMm(3000, -2000, 1000);
    Camera moved = camera;
    moved.positionMm += originMm;
    moved.targetMm += originMm;
    const RasterView view = rasterView(moved, {60, 44}, originMm).value();
    EXPECT_TRUE(validate(view).ok());
    const CameraBasis eye = basis(camera).value();
    const glm::dvec3 point(31, -17, 64);
    const glm::dvec3 d = point - camera.positionMm;
    const double tanHalf = std::tan(glm::radians(25.0));
    const double x = glm::dot(d, eye.right) / glm::dot(d, eye.forward) / tanHalf;  // -1 to 1 is the height
    const double y = glm::dot(d, eye.up) / glm::dot(d, eye.forward) / tanHalf;
    ReferenceSplats splats = oneSplat(1);
    splats.position[0] = point;
    const auto projected = projectSplats(splats, view, {}, Precision::twofold);
    EXPECT_NEAR(projected[0].mean.x, 30 + 22 * x, 1e-9);
    EXPECT_NEAR(projected[0].mean.y, 22 - 22 * y, 1e-9);
    EXPECT_NEAR(projected[0].depthMm, glm::dot(d, eye.forward), 1e-9);
}

TEST(RasterView, RefusesWhatMakesNoSense) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(rasterView({.positionMm = {0, 0, 0}}, {10, 10}, {}).ok());
    EXPECT_FALSE(rasterView({}, {0, 10}, {}).ok());
    EXPECT_FALSE(rasterView({}, {10, kMaxRasterSide + 1}, {}).ok());
    EXPECT_FALSE(rasterView({}, {10, 10}, {}, 0.0).ok());
    EXPECT_FALSE(rasterView({}, {10, 10}, {}, kNan).ok());
    const auto broken = [](auto change) {
        RasterView view = frontView();
        change(view);
        return !validate(view).ok();
    };
    EXPECT_TRUE(validate(frontView()).ok());
    EXPECT_TRUE(broken([](RasterView& v) { v.cameraFromWorld[0] *= -1.0; })) << "a mirror";
    EXPECT_TRUE(broken([](RasterView& v) { v.cameraFromWorld *= 1.1; }));
    EXPECT_TRUE(broken([](RasterView& v) { v.cameraFromWorld[1].y = kNan; }));
    EXPECT_TRUE(broken([](RasterView& v) { v.eyeMm.x = kNan; }));
    EXPECT_TRUE(broken([](RasterView& v) { v.focalPx.y = 0; }));
    EXPECT_TRUE(broken([](RasterView& v) { v.principalPx.x = kNan; }));
    for (const LowPass lowPass : kLowPasses) EXPECT_TRUE(validate(blendingOf(lowPass)).ok());
    EXPECT_FALSE(validate(Blending{.lowPassPx2 = 0.0}).ok());
    EXPECT_FALSE(validate(Blending{.lowPassPx2 = 0.3, .lowPassLeastPx2 = 0.31}).ok());
    EXPECT_FALSE(validate(Blending{.lowPassLeastPx2 = kNan}).ok());
    EXPECT_FALSE(validate(Blending{.maxAlpha = 1.0}).ok());
    EXPECT_FALSE(validate(Blending{.minAlpha = kNan}).ok());
}

}  // namespace
}  // namespace macula::splat
