// What numbers may do to the rasterizer on the device: it is the reference in double to 1e-4 by pixel, and
// its derivatives are finite.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "base/worst.h"
#include "gpu/shared_device.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/draw/model_painter.h"
#include "pipeline/splat/draw/rasterizer.h"
#include "pipeline/splat/draw/reference_rasterizer.h"
#include "splat/draw/reference_scenes.h"

namespace macula::splat {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kCapacity = 4096;

// 2 px per mm at the origin.
RasterView largeView(const glm::ivec2& sizePx = {160, 120}) {
    RasterView view = frontView(sizePx);
    view.focalPx = glm::dvec2(1000);
    return view;
}

// Grey, 0.9 opaque, 5 mm, at the origin.
Splats some(std::size_t count) {
    Splats splats;
    splats.setShDegree(1);
    splats.resize(count);
    for (auto& scale : splats.logScale) scale = glm::vec3(std::log(5.0f));
    for (auto& logit : splats.opacityLogit) logit = 2.2f;
    return splats;
}

// Depths are multiples of 1/64 mm, which a float holds exactly: so everybody sorts alike.
Splats scattered(std::uint32_t seed, std::size_t count, double lowLogScale, double highLogScale) {
    Dice dice(seed);
    Splats splats = some(count);
    for (std::size_t i = 0; i < count; ++i) {
        splats.position[i] = dice.vec3(-40, 40);
        splats.position[i].y = std::round(splats.position[i].y * 64.0f) / 64.0f;
        splats.logScale[i] = dice.vec3(lowLogScale, highLogScale);
        splats.rotation[i] = dice.quaternion();
        splats.opacityLogit[i] = static_cast<float>(dice.uniform(-3, 5));
        splats.dc[i] = dice.vec3(-1.5, 3);
        for (std::size_t k = 0; k < 3; ++k) splats.sh[3 * i + k] = dice.vec3(-0.3, 0.3);
    }
    return splats;
}

struct Off {
    double worst = 0.0;       // of colour and coverage, relative to what is brighter than 1
    double worstDepth = 0.0;  // relative to the deepest, of at least 500 mm
    std::size_t pixels = 0;   // off by more than 1e-4
    bool finite = true;
};

class RasterizerExtremes : public gpu::SharedDeviceTest {
  protected:
    struct Tools {
        SplatBuffer parameters;
        SplatBuffer gradients;
        Rasterizer rasterizer;
        RasterPass pass = {};  // of the last picture
    };
    static Tools& tools() {
        if (!tools_) {
            tools_ = std::make_unique<Tools>(
                Tools{std::move(*SplatBuffer::create(device(), "parameters", kCapacity, 1)),
                      std::move(*SplatBuffer::create(device(), "gradients", kCapacity, 1)),
                      std::move(*Rasterizer::create(device(), kCapacity, 1))});
        }
        return *tools_;
    }
    static void TearDownTestSuite() { tools_.reset(); }

    static Result<void> tryToDraw(const Splats& splats, const RasterView& view, const Blending& blending) {
        MACULA_TRY_VOID(tools().parameters.upload(componentsOf(splats)));
        MACULA_TRY(tools().pass,
                   tools().rasterizer.draw(tools().parameters, static_cast<std::uint32_t>(splats.size()),
                                           view, blending));
        return {};
    }
    static std::vector<glm::vec4> draw(const Splats& splats, const RasterView& view,
                                       const Blending& blending = {}) {
        const Result<void> drawn = tryToDraw(splats, view, blending);
        EXPECT_TRUE(drawn.ok()) << (drawn.ok() ? Text() : drawn.error().message);
        return *tools().rasterizer.picture().read();
    }

    static Off offOf(const std::vector<glm::vec4>& pixels, const std::vector<float>& depths,
                     const RasterImage& exact) {
        Off off;
        const double deepest = *std::max_element(exact.depth.begin(), exact.depth.end());
        EXPECT_EQ(pixels.size(), exact.rgba.size());
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            double worst = 0.0;
            for (int k = 0; k < 4; ++k) {
                off.finite = off.finite && std::isfinite(pixels[i][k]);
                worst = test::worse(worst, std::abs(double(pixels[i][k]) - exact.rgba[i][k]) /
                                               std::max(1.0, exact.rgba[i][k]));
            }
            off.pixels += worst > 1e-4 ? 1 : 0;
            off.worst = test::worse(off.worst, worst);
            off.finite = off.finite && std::isfinite(depths[i]);
            off.worstDepth =
                test::worse(off.worstDepth, std::abs(double(depths[i]) - exact.depth[i]) / (500.0 + deepest));
        }
        return off;
    }

    // The picture in double, which the one on the device is like.
    static RasterImage expectLikeReference(const Splats& splats, const RasterView& view,
                                           const Blending& blending = {}) {
        const std::vector<glm::vec4> pixels = draw(splats, view, blending);
        const auto depths = gpu::read<float>(tools().rasterizer.depths());
        RasterImage exact = rasterize(ReferenceSplats(splats), view, blending, Precision::twofold);
        const Off off = offOf(pixels, *depths, exact);
        EXPECT_TRUE(off.finite);
        EXPECT_LT(off.worst, 1e-4);
        EXPECT_LT(off.worstDepth, 1e-4);
        return exact;
    }

    // Of the sum of all that pixels show, weighted by chance: finite, and those of the reference in double,
    // to 1e-3 of the greatest of a component, or 1e-6 of the greatest of all: a sphere has nothing by its
    // rotation but rounding.
    static void expectGradients(const Splats& splats, const RasterView& view, const Blending& blending = {}) {
        const RasterImage exact = expectLikeReference(splats, view, blending);
        const std::size_t pixels = exact.rgba.size();
        Dice dice(9);
        RasterGradient gradient{.rgba = std::vector<glm::dvec4>(pixels), .depth = {}};
        std::vector<glm::vec4> single(pixels);
        for (std::size_t i = 0; i < pixels; ++i) {
            single[i] = glm::vec4(dice.vec3(-1, 1), dice.uniform(-1, 1));
            gradient.rgba[i] = single[i];
        }
        const auto uploaded =
            DevicePicture::upload(device(), "gradient", view.sizePx.x, view.sizePx.y, single);
        ASSERT_TRUE(uploaded.ok());
        ASSERT_TRUE(tools().gradients.upload({}).ok());  // 0, as of splats that do not show
        auto recorder = std::move(*gpu::Recorder::create(device(), "test"));
        ASSERT_TRUE(
            tools()
                .rasterizer
                .recordBackward(recorder, tools().pass, tools().parameters, *uploaded, tools().gradients)
                .ok());
        ASSERT_TRUE(recorder.submit().ok());
        const auto count = static_cast<std::uint32_t>(splats.size());
        const auto found = tools().gradients.download(count);
        ASSERT_TRUE(found.ok());

        const ReferenceSplats model(splats);
        const std::vector<float> expected = componentsOf(
            singleOf(rasterizeBackward(model, view, blending, exact, gradient, Precision::twofold)));
        double greatest = 0.0;
        for (const float g : expected) greatest = std::max(greatest, std::abs(double(g)));
        for (std::size_t k = 0; k < std::size_t(componentCount(1)); ++k) {
            double most = 0.0;
            double off = 0.0;
            for (std::size_t n = k * count; n < (k + 1) * count; ++n) {
                ASSERT_TRUE(std::isfinite((*found)[n])) << "component " << k;
                most = std::max(most, std::abs(double(expected[n])));
                off = test::worse(off, std::abs(double((*found)[n]) - double(expected[n])));
            }
            EXPECT_LE(off, 1e-3 * most + 1e-6 * greatest) << "component " << k << ", most " << most;
        }
    }

  private:
    static inline std::unique_ptr<Tools> tools_;
};

TEST_F(RasterizerExtremes, OneSplatOfAnySize) {
    EXPECT_GT(coverageSum(expectLikeReference(some(1), largeView())), 100.0);
    expectGradients(some(1), largeView());
    // Smaller than a pixel, without volume, as large as the picture, around the eye, without end.
    for (const float logScale : {-100.0f, -20.0f, -6.0f, -3.0f, -1.0f, 6.0f, 10.0f, 20.0f, 100.0f}) {
        Splats splats = some(1);
        splats.position[0] = {1.25f, 0.5f, -3.0f};
        splats.logScale[0] = glm::vec3(logScale);
        const double sum = coverageSum(expectLikeReference(splats, largeView()));
        if (logScale >= 6.0f) {
            EXPECT_NEAR(sum, 0.9 * 160 * 120, 200.0);
        }
        expectLikeReference(splats, largeView(), {.minAlpha = 1e-9});
        expectGradients(splats, largeView());
        splats.logScale[0] = {2.0f, logScale, 2.0f};  // a disc, a needle
        expectGradients(splats, largeView());
        splats.logScale[0] = {logScale, 2.0f, logScale};
        expectGradients(splats, largeView());
    }
}

TEST_F(RasterizerExtremes, Needles) {
    // 1 : 10 000, 2 000 px long and 0.2 px thin; in any direction, and along the line of sight.
    Dice dice(3);
    double shown = 0.0;
    for (int n = 0; n < 24; ++n) {
        Splats splats = some(1);
        splats.logScale[0] = {std::log(0.1f), std::log(1000.0f), std::log(0.1f)};
        splats.rotation[0] = n < 20 ? glm::vec4(dice.quaternion()) : glm::vec4(1, 0, 0, 0);
        splats.position[0] = dice.vec3(-20, 20);
        shown += coverageSum(expectLikeReference(splats, largeView()));
        expectGradients(splats, largeView());
    }
    EXPECT_GT(shown, 100.0);
}

TEST_F(RasterizerExtremes, BehindTheEyeAndAtTheNearPlane) {
    for (const float y : {-498.0f - 1.0f / 1024, -498.0f, -498.0f + 1.0f / 1024, -497.0f, -500.0f, -501.0f,
                          -600.0f, -1e5f, -1e30f}) {
        for (const float logScale : {-2.0f, 1.6f, 5.0f}) {
            Splats splats = some(1);
            splats.position[0] = {0.01f, y, 0.02f};
            splats.logScale[0] = glm::vec3(logScale);
            const RasterImage image = expectLikeReference(splats, largeView());
            EXPECT_EQ(coverageSum(image) > 0.0, y >= -498.0f) << y;
            expectGradients(splats, largeView());
        }
    }
    // Far off the axis and near: where the linear part is taken at the border.
    for (const float logScale : {0.0f, 6.0f, 20.0f}) {
        Splats splats = some(1);
        splats.position[0] = {3000, -480, 1000};
        splats.logScale[0] = {logScale, -logScale, 0};
        expectGradients(splats, largeView());
    }
}

TEST_F(RasterizerExtremes, OpacityOfZeroAndOne) {
    Splats splats = some(3);
    splats.position[1].x = 10;
    splats.position[2].x = -10;
    for (const float logit : {-80.0f, -3e38f, -5.5f, 80.0f, 3e38f}) {
        splats.opacityLogit[0] = splats.opacityLogit[1] = logit;
        expectGradients(splats, largeView());
    }
    EXPECT_NEAR(at(expectLikeReference(splats, largeView()), 80, 60).a, 0.995, 0.00501);
}

TEST_F(RasterizerExtremes, FarAway) {
    // The model and the eye from the world's origin: the same picture, to the last bit.
    const Splats splats = scattered(2, 200, -1, 2);
    const std::vector<glm::vec4> here = draw(splats, frontView({61, 47}));
    const Camera camera{
        .positionMm = {1e5, -500 - 1e5, 1e5}, .targetMm = {1e5, -1e5, 1e5}, .verticalFovDeg = 12};
    EXPECT_EQ(draw(splats, rasterView(camera, {61, 47}, {1e5, -1e5, 1e5}).value()), here);
    // The splat from the eye.
    for (const float y : {1e5f, 1e7f, 1e12f, 1e25f}) {
        Splats far = some(1);
        far.position[0] = {0, y, 0};
        far.logScale[0] = glm::vec3(std::log(y) - 5.0f);
        expectGradients(far, largeView());
        far.position[0] = {y, 100, -y};
        expectGradients(far, largeView());
    }
    // A model whose own coordinates are that large, a trainer's that knows no origin: float has 1/128 mm
    // then, and eye and splats have the same.
    Splats shifted = scattered(4, 200, -1, 2);
    for (glm::vec3& p : shifted.position) p = glm::round(p * 64.0f) / 64.0f + glm::vec3(1e5f, -1e5f, 1e5f);
    RasterView view = frontView({61, 47});
    view.eyeMm += glm::dvec3(1e5, -1e5, 1e5);
    expectLikeReference(shifted, view);
}

TEST_F(RasterizerExtremes, QuaternionsOfAnyLength) {
    Splats splats = scattered(5, 60, -1, 2);
    for (const float length : {0.0f, 1e-35f, 1e-6f, 1e6f, 1e37f}) {
        Splats changed = splats;
        for (std::size_t i = 0; i < changed.size(); i += 2) changed.rotation[i] *= length;
        expectLikeReference(changed, largeView());
        if (length > 1e-30f && length < 1e30f) expectGradients(changed, largeView());
    }
}

TEST_F(RasterizerExtremes, WhatIsNotFiniteIsNotDrawnAndHarmsNothing) {
    const Splats good = scattered(6, 100, -1, 2);
    std::vector<std::function<void(Splats&, std::size_t, float)>> changes{
        [](Splats& s, std::size_t i, float v) { s.position[i].x = v; },
        [](Splats& s, std::size_t i, float v) { s.logScale[i].z = v; },
        [](Splats& s, std::size_t i, float v) { s.rotation[i].w = v; },
        [](Splats& s, std::size_t i, float v) { s.opacityLogit[i] = v; },
        [](Splats& s, std::size_t i, float v) { s.dc[i].y = v; },
        [](Splats& s, std::size_t i, float v) { s.sh[3 * i + 2].y = v; }};
    // Each third splat is bad; the picture is that of the others, which keep their order.
    Splats others = some(66);
    for (std::size_t i = 0, k = 0; i < good.size(); ++i) {
        if (i % 3 == 0) continue;
        others.position[k] = good.position[i];
        others.logScale[k] = good.logScale[i];
        others.rotation[k] = good.rotation[i];
        others.opacityLogit[k] = good.opacityLogit[i];
        others.dc[k] = good.dc[i];
        std::copy_n(&good.sh[3 * i], 3, &others.sh[3 * k]);
        ++k;
    }
    const std::vector<glm::vec4> expected = draw(others, largeView());
    for (const auto& change : changes) {
        for (const float value : {kNan, kInfinity, -kInfinity}) {
            Splats bad = good;
            for (std::size_t i = 0; i < bad.size(); i += 3) change(bad, i, value);
            EXPECT_EQ(draw(bad, largeView()), expected);
        }
    }
    Splats bad = good;
    for (std::size_t i = 0; i < bad.size(); i += 3) changes[i % changes.size()](bad, i, kNan);
    expectGradients(bad, largeView());
}

TEST_F(RasterizerExtremes, PicturesOfAnySize) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), {1, 300}, {333, 1}, {7, 15}, {8, 16}, {9, 17}}) {
        const Splats splats = scattered(7, 100, -1, 2.5);
        expectGradients(splats, largeView(size));
    }
    RasterView view = frontView({2000, 2000});
    expectLikeReference(scattered(8, 20, 0, 3), view);
}

TEST_F(RasterizerExtremes, OfEquallyDeepOnesTheFirstIsInFront) {
    Splats splats = scattered(9, 300, 0, 2);
    for (std::size_t i = 0; i < splats.size(); ++i) splats.position[i].y = i % 2 == 0 ? 0.0f : 0.5f;
    expectGradients(splats, largeView());
}

TEST_F(RasterizerExtremes, HardEdgesDifferByNoMoreThanTheyAreHigh) {
    const Blending classic = blendingOf(LowPass::classic);
    const Splats splats = scattered(10, 1000, -1, 2.5);
    const std::vector<glm::vec4> pixels = draw(splats, largeView(), classic);
    const auto depths = gpu::read<float>(tools().rasterizer.depths());
    const RasterImage exact = rasterize(ReferenceSplats(splats), largeView(), classic, Precision::twofold);
    const Off off = offOf(pixels, *depths, exact);
    EXPECT_TRUE(off.finite);
    // A pixel has some 100 edges, each with about 1e-6 of its alpha where it may fall to either side.
    EXPECT_LE(off.pixels, pixels.size() / 1000);
    EXPECT_LT(off.worst, 2.0 / 255.0 * 2.5);  // times the brightest colour
}

TEST_F(RasterizerExtremes, AMillionSplats) {
    constexpr std::uint32_t kMillion = 1'000'000;
    Splats splats = scattered(12, kMillion, -3, -0.5);
    splats.setShDegree(0);
    const RasterView view = frontView({48, 40});
    ModelPainter painter = std::move(*ModelPainter::create(device(), splats));
    EXPECT_FALSE(painter.projectsOnHost());
    const auto picture = painter.draw(view);
    ASSERT_TRUE(picture.ok());
    const RasterImage exact = rasterize(ReferenceSplats(splats), view, {}, Precision::twofold);
    const Off off = offOf(picture->rgba, picture->depthSums, exact);
    EXPECT_TRUE(off.finite);
    EXPECT_LT(off.worst, 1e-4);
    EXPECT_LT(off.worstDepth, 1e-4);
    EXPECT_GT(coverageSum(exact), 0.5 * 48 * 40);
}

TEST_F(RasterizerExtremes, ProjectedOnTheHostItIsTheSamePicture) {
    for (const int degree : {0, 1, 2, 3}) {
        Splats splats = scattered(13, 500, -1, 2);
        splats.setShDegree(degree);
        Dice dice(1);
        for (glm::vec3& s : splats.sh) s = dice.vec3(-0.3, 0.3);
        splats.position[7].x = kNan;
        splats.dc[8].x = kInfinity;
        ModelPainter painter =
            std::move(*ModelPainter::create(device(), splats, ModelPainter::Projection::onHost));
        EXPECT_TRUE(painter.projectsOnHost());
        const auto picture = painter.draw(largeView());
        ASSERT_TRUE(picture.ok());
        const RasterImage exact = rasterize(ReferenceSplats(splats), largeView(), {}, Precision::twofold);
        EXPECT_LT(offOf(picture->rgba, picture->depthSums, exact).worst, 1e-4);
    }
    const Splats none;
    ModelPainter painter = std::move(*ModelPainter::create(device(), none));
    const auto empty = painter.draw(largeView());
    ASSERT_TRUE(empty.ok());
    for (const glm::vec4& pixel : empty->rgba) ASSERT_EQ(pixel, glm::vec4(0.0f));
}

TEST_F(RasterizerExtremes, TooMuchIsAnErrorAndTheNextPictureIsRight) {
    // On a graphics card tiles are half as high, and the one splat lies in twice as many.
    const std::uint64_t mostPairs = device()->isCpu() ? 50 : 100;
    Rasterizer few = std::move(*Rasterizer::create(device(), kCapacity, 1, {.mostPairs = mostPairs}));
    const Splats splats = scattered(14, 500, 0, 3);
    const Splats one = some(1);
    ASSERT_TRUE(tools().parameters.upload(componentsOf(splats)).ok());
    const Result<RasterPass> tooMany = few.draw(tools().parameters, 500, largeView(), {});
    ASSERT_FALSE(tooMany.ok());
    EXPECT_EQ(tooMany.error().code, ErrorCode::outOfMemory);
    EXPECT_NE(tooMany.error().message.english().find("too many"), std::string::npos);
    ASSERT_TRUE(tools().parameters.upload(componentsOf(one)).ok());
    ASSERT_TRUE(few.draw(tools().parameters, 1, largeView(), {}).ok());
    EXPECT_EQ(*few.picture().read(), draw(one, largeView()));

    // 4 GiB, more than any device has in one buffer of that kind.
    const Result<void> tooLarge = tryToDraw(one, frontView({kMaxRasterSide, kMaxRasterSide}), {});
    ASSERT_FALSE(tooLarge.ok());
    EXPECT_EQ(tooLarge.error().code, ErrorCode::outOfMemory);
    expectGradients(splats, largeView());
}

// Splats of all sizes, many of whose centres lie beside the picture, some far: in bands they are where they
// were.
TEST_F(RasterizerExtremes, BandsAreThePictureInParts) {
    const Splats splats = scattered(77, 300, -1.0, 4.5);
    const RasterView view = largeView({160, 121});
    for (const auto projection : {ModelPainter::Projection::wherever, ModelPainter::Projection::onHost}) {
        ModelPainter painter = std::move(*ModelPainter::create(device(), splats, projection));
        const SplatPicture whole = std::move(*painter.draw(view));
        SplatPicture joined;
        std::vector<int> rows;
        const auto take = [&](const SplatPicture& band) -> Result<void> {
            EXPECT_EQ(band.sizePx.x, 160);
            rows.push_back(band.sizePx.y);
            joined.rgba.insert(joined.rgba.end(), band.rgba.begin(), band.rgba.end());
            joined.depthSums.insert(joined.depthSums.end(), band.depthSums.begin(), band.depthSums.end());
            return {};
        };
        ASSERT_TRUE(painter.drawBands(view, take, 160 * 25 + 7).ok());
        EXPECT_EQ(rows, (std::vector<int>{25, 25, 25, 25, 21}));
        ASSERT_EQ(joined.rgba.size(), whole.rgba.size());
        ASSERT_EQ(joined.depthSums.size(), whole.depthSums.size());
        double worst = 0.0;
        for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
            for (int c = 0; c < 4; ++c)
                worst = test::worse(worst, std::abs(double(joined.rgba[i][c]) - double(whole.rgba[i][c])));
            worst =
                test::worse(worst, std::abs(double(joined.depthSums[i]) - double(whole.depthSums[i])) / 500);
        }
        EXPECT_LT(worst, 2e-4);
        // And what cannot be taken ends it.
        int taken = 0;
        const auto refuse = [&](const SplatPicture&) -> Result<void> {
            return ++taken < 2 ? Result<void>()
                               : Result<void>(Error{ErrorCode::cancelled, Text("Stopped."), {}, {}});
        };
        EXPECT_EQ(painter.drawBands(view, refuse, 160 * 25).error().code, ErrorCode::cancelled);
        EXPECT_EQ(taken, 2);
    }
}

}  // namespace
}  // namespace macula::splat
