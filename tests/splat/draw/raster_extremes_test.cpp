// What numbers may do to a rasterizer. Everything is finite, in float and in double, and float is double to
// 1e-4 by pixel.
#include <functional>
#include <limits>

#include "base/worst.h"
#include "splat/draw/reference_scenes.h"

namespace macula::splat {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A picture large enough for needles to be long in it: 2 px per mm at the origin.
RasterView largeView() {
    RasterView view = frontView({160, 120});
    view.focalPx = glm::dvec2(1000);
    return view;
}

bool isFinite(const ReferenceSplats& g) {
    bool finite = true;
    for (std::size_t i = 0; i < g.size(); ++i)
        finite = finite && splat::isFinite(g.position[i]) && splat::isFinite(g.logScale[i]) &&
                 splat::isFinite(g.rotation[i]) && std::isfinite(g.opacityLogit[i]) &&
                 splat::isFinite(g.dc[i]);
    for (const glm::dvec3& v : g.sh) finite = finite && splat::isFinite(v);
    return finite;
}

// The picture in double. `model` is of floats, so that both precisions begin with the same numbers.
RasterImage expectSound(const Splats& model, const RasterView& view, const Blending& blending = {}) {
    const ReferenceSplats splats(model);
    RasterImage exact = rasterize(splats, view, blending, Precision::twofold);
    const RasterImage rounded = rasterize(splats, view, blending, Precision::single);
    double worst = 0.0;
    double worstDepth = 0.0;
    for (std::size_t i = 0; i < exact.rgba.size(); ++i) {
        EXPECT_TRUE(splat::isFinite(exact.rgba[i]) && splat::isFinite(rounded.rgba[i]));
        EXPECT_TRUE(std::isfinite(exact.depth[i]) && std::isfinite(rounded.depth[i]));
        for (int k = 0; k < 4; ++k)
            worst = test::worse(
                worst, std::abs(exact.rgba[i][k] - rounded.rgba[i][k]) / std::max(1.0, exact.rgba[i][k]));
        worstDepth =
            test::worse(worstDepth, std::abs(exact.depth[i] - rounded.depth[i]) / (500.0 + exact.depth[i]));
    }
    EXPECT_LT(worst, 1e-4);
    EXPECT_LT(worstDepth, 1e-4);
    const std::size_t count = exact.rgba.size();
    const RasterGradient ones{std::vector<glm::dvec4>(count, glm::dvec4(1.0)),
                              std::vector<double>(count, 1.0)};
    for (const Precision precision : {Precision::single, Precision::twofold}) {
        const auto& image = precision == Precision::single ? rounded : exact;
        EXPECT_TRUE(isFinite(rasterizeBackward(splats, view, blending, image, ones, precision)));
    }
    return exact;
}

// One splat of 0.9, grey, at the origin, 5 mm.
Splats one() {
    Splats splats;
    splats.setShDegree(1);
    splats.resize(1);
    splats.logScale[0] = glm::vec3(std::log(5.0f));
    splats.opacityLogit[0] = 2.2f;
    return splats;
}

glm::vec4 turned(const glm::dvec3& axis, double angle) {
    return {std::cos(angle / 2), glm::dvec3(std::sin(angle / 2)) * glm::normalize(axis)};
}

TEST(RasterExtremes, NoSplatAndOneSplat) {
    Splats none;
    EXPECT_EQ(coverageSum(expectSound(none, largeView())), 0.0);
    EXPECT_GT(coverageSum(expectSound(one(), largeView())), 100.0);
    RasterView pixel = largeView();
    pixel.sizePx = {1, 1};
    pixel.principalPx = {0.5, 0.5};
    EXPECT_NEAR(coverageSum(expectSound(one(), pixel)), 0.9, 0.01);
}

TEST(RasterExtremes, Needles) {
    // Across the picture, 2 000 px long and 0.2 px thin; and along the line of sight.
    Dice dice(3);
    for (int n = 0; n < 40; ++n) {
        Splats splats = one();
        splats.logScale[0] = {std::log(0.1f), std::log(1000.0f), std::log(0.1f)};
        splats.rotation[0] = dice.quaternion();
        if (n < 20) {  // about the line of sight
            splats.rotation[0] = turned({0, 1, 0}, dice.uniform(0, 7));
            splats.logScale[0] = {std::log(0.1f), std::log(0.1f), std::log(1000.0f)};
        }
        splats.position[0] = glm::vec3(dice.vec3(-20, 20));
        const RasterImage image = expectSound(splats, largeView());
        EXPECT_GT(coverageSum(image), n < 20 ? 5.0 : -1.0);
    }
    Splats pointing = one();
    pointing.logScale[0] = {std::log(0.1f), std::log(100.0f), std::log(0.01f)};
    EXPECT_GT(coverageSum(expectSound(pointing, largeView())), 0.0);
}

TEST(RasterExtremes, SmallerThanAPixelAndWithoutVolume) {
    for (const float logScale : {-1.0f, -3.0f, -6.0f, -20.0f, -100.0f}) {
        Splats splats = one();
        splats.logScale[0] = glm::vec3(logScale);
        expectSound(splats, largeView());
        expectSound(splats, largeView(), {.minAlpha = 1e-9});
        expectSound(splats, largeView(), blendingOf(LowPass::classic));
        // A needle and a disc without volume, the disc seen along its plane and nearly so.
        splats.logScale[0] = {2.0f, logScale, logScale};
        expectSound(splats, largeView());
        splats.logScale[0] = {2.0f, 2.0f, logScale};
        expectSound(splats, largeView());
        splats.logScale[0] = {logScale, 2.0f, 2.0f};
        splats.rotation[0] = turned({0, 0, 1}, 1e-4);
        expectSound(splats, largeView());
        expectSound(splats, largeView(), blendingOf(LowPass::classic));
    }
    // Seen from the front a disc without thickness is as opaque as any.
    Splats disc = one();
    disc.logScale[0] = {2.0f, -100.0f, 2.0f};
    EXPECT_NEAR(at(expectSound(disc, largeView()), 80, 60).a, 0.9, 0.01);
}

TEST(RasterExtremes, FillingTheScreenAndAroundTheEye) {
    for (const float logScale : {6.0f, 10.0f, 20.0f, 100.0f}) {
        Splats splats = one();
        splats.logScale[0] = glm::vec3(logScale);
        EXPECT_NEAR(coverageSum(expectSound(splats, largeView())), 0.9 * 160 * 120, 200.0);
        for (const float y : {-500.0f, -498.1f, -497.9f, -497.0f, -450.0f}) {
            splats.position[0] = {1, y, 2};
            const RasterImage image = expectSound(splats, largeView());
            EXPECT_EQ(coverageSum(image) > 0.0, y > -498.0f) << "the near plane is at 2 mm";
        }
        // Far off the axis and large: the clamped Jacobian.
        splats.position[0] = {3000, -480, 1000};
        expectSound(splats, largeView());
        splats.logScale[0] = {logScale, -logScale, 0};
        expectSound(splats, largeView());
    }
}

TEST(RasterExtremes, BehindTheCamera) {
    Splats splats = one();
    for (const float y : {-500.0f, -501.0f, -600.0f, -1e5f, -1e30f}) {
        splats.position[0].y = y;
        EXPECT_EQ(coverageSum(expectSound(splats, largeView())), 0.0);
    }
}

TEST(RasterExtremes, OpacityZeroAndOne) {
    Splats splats = one();
    splats.opacityLogit[0] = -80;
    EXPECT_EQ(coverageSum(expectSound(splats, largeView())), 0.0);
    splats.opacityLogit[0] = 80;
    EXPECT_NEAR(at(expectSound(splats, largeView()), 80, 60).a, 0.99, 1e-6);
    splats.opacityLogit[0] = 3e38f;
    EXPECT_NEAR(at(expectSound(splats, largeView()), 80, 60).a, 0.99, 1e-6);
    // Just above what is drawn.
    splats.opacityLogit[0] = -5.5f;
    expectSound(splats, largeView());
}

TEST(RasterExtremes, FarAway) {
    // Far from the world's origin: nothing is lost, because the eye is given relative to the model.
    const Camera camera{
        .positionMm = {1e5, -500 - 1e5, 1e5}, .targetMm = {1e5, -1e5, 1e5}, .verticalFovDeg = 12};
    const RasterView view = rasterView(camera, {28, 24}, {1e5, -1e5, 1e5}).value();
    EXPECT_EQ(rasterize(ReferenceSplats(one()), view, {}, Precision::twofold).rgba,
              rasterize(ReferenceSplats(one()), frontView(), {}, Precision::twofold).rgba);
    // Far from the eye.
    Splats splats = one();
    splats.position[0].y = 1e5f;
    splats.logScale[0] = glm::vec3(std::log(500.0f));
    EXPECT_GT(coverageSum(expectSound(splats, largeView())), 100.0);
    for (const float y : {1e7f, 1e12f, 1e25f, 1e38f}) {
        splats.position[0] = {0, y, 0};
        expectSound(splats, largeView());
        splats.position[0] = {y, 100, -y};
        EXPECT_EQ(coverageSum(expectSound(splats, largeView())), 0.0);
    }
}

TEST(RasterExtremes, QuaternionsOfAnyLength) {
    Splats splats = one();
    splats.logScale[0] = {0.0f, 1.0f, 2.0f};
    const RasterImage plain = expectSound(splats, largeView());
    splats.rotation[0] = glm::vec4(0.0f);  // no rotation
    EXPECT_EQ(expectSound(splats, largeView()).rgba, plain.rgba);
    for (const float length : {1e-35f, 1e-6f, 1e6f, 1e37f}) {
        splats.rotation[0] = {length, 0, 0, 0};
        EXPECT_EQ(expectSound(splats, largeView()).rgba, plain.rgba);
    }
}

TEST(RasterExtremes, WhatIsNotFiniteIsNotDrawn) {
    const auto with = [](const std::function<void(Splats&, float)>& change) {
        for (const float value : {kNan, kInfinity, -kInfinity}) {
            Splats splats = one();
            change(splats, value);
            EXPECT_EQ(coverageSum(expectSound(splats, largeView())), 0.0);
        }
    };
    with([](Splats& s, float v) { s.position[0].x = v; });
    with([](Splats& s, float v) { s.logScale[0].z = v; });
    with([](Splats& s, float v) { s.rotation[0].w = v; });
    with([](Splats& s, float v) { s.opacityLogit[0] = v; });
    with([](Splats& s, float v) { s.dc[0].y = v; });
    with([](Splats& s, float v) { s.sh[2].y = v; });
}

TEST(RasterExtremes, ManySplatsInFloat) {
    Dice dice(11);
    Splats splats;
    splats.setShDegree(1);
    splats.resize(3000);
    for (std::size_t i = 0; i < splats.size(); ++i) {
        splats.position[i] = dice.vec3(-50, 50);
        splats.logScale[i] = dice.vec3(-4, 2);
        splats.rotation[i] = dice.quaternion();
        splats.opacityLogit[i] = static_cast<float>(dice.uniform(-3, 5));
        splats.dc[i] = dice.vec3(-2, 3);
        for (std::size_t k = 0; k < 3; ++k) splats.sh[3 * i + k] = dice.vec3(-0.3, 0.3);
    }
    EXPECT_GT(coverageSum(expectSound(splats, largeView())), 5000.0);
}

}  // namespace
}  // namespace macula::splat
