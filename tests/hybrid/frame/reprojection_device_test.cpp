// A picture from one eye as another sees it: held to the same in double, to what is really seen from there,
// and at the extremes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "gpu/shared_device.h"
#include "gpu/shared_layout.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/hybrid/frame/reference_reprojection.h"
#include "pipeline/hybrid/frame/reprojection.h"
#include "pipeline/hybrid/frame/texel_room.h"
#include "shaders/hybrid.h"

namespace macula::hybrid {
namespace {

constexpr glm::ivec2 kSize{160, 120};
const Box kSeen{glm::dvec3(-100.0), glm::dvec3(100.0)};

Camera cameraAt(const glm::dvec3& positionMm, const glm::dvec3& targetMm = glm::dvec3(0.0)) {
    return {.positionMm = positionMm, .targetMm = targetMm, .up = {0, 0, 1}, .verticalFovDeg = 30.0};
}

// A ball before a wall, each in stripes of its own place; what lies beside the wall is empty.
struct Scene {
    static constexpr double kBallMm = 30.0;
    static constexpr double kWallY = 60.0;
    static constexpr double kWallHalfMm = 75.0;

    struct Seen {
        glm::dvec4 light{0.0};
        double depthMm = -1.0;
    };
    static Seen from(const glm::dvec3& eye, const glm::dvec3& ray) {
        const double along = -glm::dot(eye, ray);
        const double inside = kBallMm * kBallMm - glm::dot(eye, eye) + along * along;
        if (inside > 0.0) return at(eye, ray, along - std::sqrt(inside), {0.9, 0.4, 0.3});
        const double t = (kWallY - eye.y) / ray.y;
        const glm::dvec3 p = eye + ray * t;
        if (t > 0.0 && std::max(std::abs(p.x), std::abs(p.z)) < kWallHalfMm)
            return at(eye, ray, t, {0.3, 0.5, 0.9});
        return {};
    }

  private:
    static Seen at(const glm::dvec3& eye, const glm::dvec3& ray, double depthMm, const glm::dvec3& colour) {
        const glm::dvec3 p = eye + ray * depthMm;
        const double stripes = 0.75 + 0.25 * std::sin(0.25 * p.x) * std::sin(0.25 * p.z);
        return {.light = glm::dvec4(colour * stripes, 1.0), .depthMm = depthMm};
    }
};

std::vector<glm::dvec3> raysOf(const Camera& camera, const glm::ivec2& sizePx) {
    const CameraBasis axes = *basis(camera);
    const double halfHeight = std::tan(0.5 * glm::radians(camera.verticalFovDeg));
    const double halfWidth = halfHeight * sizePx.x / sizePx.y;
    std::vector<glm::dvec3> rays;
    for (int y = 0; y < sizePx.y; ++y) {
        for (int x = 0; x < sizePx.x; ++x) {
            rays.push_back(glm::normalize(axes.forward +
                                          axes.right * (halfWidth * ((2.0 * x + 1.0) / sizePx.x - 1.0)) +
                                          axes.up * (halfHeight * (1.0 - (2.0 * y + 1.0) / sizePx.y))));
        }
    }
    return rays;
}

ReferenceCapture captureOf(const Camera& camera, const glm::ivec2& sizePx) {
    ReferenceCapture picture;
    for (const glm::dvec3& ray : raysOf(camera, sizePx)) {
        const Scene::Seen seen = Scene::from(camera.positionMm, ray);
        picture.lights.push_back(seen.light);
        picture.depths.emplace_back(seen.depthMm, 0.0);
    }
    return picture;
}

ReferenceReprojection reprojected(const ReferenceCapture& picture, const Camera& before, const Camera& now,
                                  double edgeFade = 0.0) {
    return reproject(*reprojectionOf(before, kSize, now, kSize, kSeen, edgeFade), picture);
}

// Along the middle of the view, as splats of the scene would tell it, but for errors of some millimetres.
std::vector<double> depthsAlongView(const Camera& now) {
    const glm::dvec3 forward = basis(now)->forward;
    std::vector<double> depths;
    for (const glm::dvec3& ray : raysOf(now, kSize)) {
        const double error = 8.0 * std::sin(0.1 * double(depths.size()));
        const double depthMm = Scene::from(now.positionMm, ray).depthMm;
        depths.push_back(depthMm < 0.0 ? -1.0 : depthMm * glm::dot(ray, forward) + error);
    }
    return depths;
}

// How a reprojected picture compares with what is there.
struct Comparison {
    std::size_t known = 0;    // pixels of weight above one half
    std::size_t wrong = 0;    // of these, beyond what is seen in the nine pixels around
    std::size_t through = 0;  // of these, background where there is matter in all nine
    double meanOff = 0.0;     // of known ones, of colour
};
Comparison compare(const ReferenceReprojection& found, const Camera& now) {
    const std::vector<glm::dvec3> rays = raysOf(now, kSize);
    Comparison result;
    for (int y = 1; y + 1 < kSize.y; ++y) {
        for (int x = 1; x + 1 < kSize.x; ++x) {
            const auto index = std::size_t(y) * kSize.x + std::size_t(x);
            if (found.weights[index] <= 0.5) continue;
            ++result.known;
            glm::dvec4 least(10.0);
            glm::dvec4 most(0.0);
            bool isMatter = true;
            for (int k = 0; k < 9; ++k) {
                const auto other = index + std::size_t((k / 3 - 1) * kSize.x) + std::size_t(k % 3) - 1;
                const Scene::Seen seen = Scene::from(now.positionMm, rays[other]);
                least = glm::min(least, seen.light);
                most = glm::max(most, seen.light);
                isMatter = isMatter && seen.depthMm > 0.0;
            }
            const glm::dvec4 off = glm::max(least - found.lights[index], found.lights[index] - most);
            result.wrong += std::max({off.x, off.y, off.z, off.w}) > 0.02 ? 1 : 0;
            result.through += isMatter && found.lights[index].w < 0.5 ? 1 : 0;
            const Scene::Seen here = Scene::from(now.positionMm, rays[index]);
            result.meanOff += glm::length(here.light - found.lights[index]);
        }
    }
    result.meanOff /= double(std::max<std::size_t>(result.known, 1));
    return result;
}

TEST(ReprojectLayout, PushConstantsAgree) {
    using shared::CapturePush;
    using shared::ReprojectPush;
    const auto reproject = gpu::reflectSpirv(shaders::hybrid_reproject_comp.words);
    ASSERT_TRUE(reproject.ok());
    expectLayoutMatches<ReprojectPush>(
        *reproject->pushConstants->block.find("reproject"),
        {MACULA_FIELD(ReprojectPush, right), MACULA_FIELD(ReprojectPush, up),
         MACULA_FIELD(ReprojectPush, forward), MACULA_FIELD(ReprojectPush, oursMm),
         MACULA_FIELD(ReprojectPush, beforeRight), MACULA_FIELD(ReprojectPush, beforeUp),
         MACULA_FIELD(ReprojectPush, beforeForward), MACULA_FIELD(ReprojectPush, middleMm),
         MACULA_FIELD(ReprojectPush, radiusMm), MACULA_FIELD(ReprojectPush, size),
         MACULA_FIELD(ReprojectPush, beforeSize), MACULA_FIELD(ReprojectPush, firstPx),
         MACULA_FIELD(ReprojectPush, edgeFade)});
    const auto capture = gpu::reflectSpirv(shaders::hybrid_capture_comp.words);
    ASSERT_TRUE(capture.ok());
    expectLayoutMatches<CapturePush>(
        *capture->pushConstants->block.find("push"),
        {MACULA_FIELD(CapturePush, size), MACULA_FIELD(CapturePush, firstPx),
         MACULA_FIELD(CapturePush, tracedSize), MACULA_FIELD(CapturePush, pixelAngle),
         MACULA_FIELD(CapturePush, thinMm), MACULA_FIELD(CapturePush, areMeans)});
}

TEST(FeatherLayout, PushConstantsAgree) {
    using shared::FeatherPush;
    const auto feather = gpu::reflectSpirv(shaders::hybrid_feather_comp.words);
    ASSERT_TRUE(feather.ok());
    expectLayoutMatches<FeatherPush>(*feather->pushConstants->block.find("push"),
                                     {MACULA_FIELD(FeatherPush, size), MACULA_FIELD(FeatherPush, firstPx)});
}

TEST(Feather, KeepsWhatIsKnownAndSoftensItsBorder) {
    constexpr glm::ivec2 kPlane{20, 9};
    const auto at = [&](const std::vector<double>& weights, int x, int y) {
        return weights[std::size_t(y) * kPlane.x + std::size_t(x)];
    };
    std::vector<double> all(20 * 9, 1.0);
    EXPECT_EQ(feather(kPlane, all), all);
    std::vector<double> half = all;
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 10; ++x) half[std::size_t(y) * 20 + std::size_t(x)] = 0.0;
    }
    const std::vector<double> soft = feather(kPlane, half);
    EXPECT_EQ(at(soft, 9, 4), 0.0);
    EXPECT_NEAR(at(soft, 10, 4), 0.104, 1e-9);  // 3 of 5 columns: t = 0.2
    EXPECT_NEAR(at(soft, 11, 4), 0.648, 1e-9);  // 4 of 5: t = 0.6
    EXPECT_EQ(at(soft, 12, 4), 1.0);
    std::vector<double> alone(20 * 9, 0.0);
    alone[4 * 20 + 10] = 1.0;
    EXPECT_EQ(feather(kPlane, alone), std::vector<double>(20 * 9, 0.0));
    EXPECT_EQ(feather({1, 1}, std::vector<double>{0.7}), std::vector<double>{0.7});
}

TEST(Reproject, TheSameEyeSeesTheSamePicture) {
    const Camera eye = cameraAt({20, -420, 35});
    const ReferenceCapture picture = captureOf(eye, kSize);
    // Whatever splats show: they mix the depths of what lies behind one another.
    const auto push = *reprojectionOf(eye, kSize, eye, kSize, kSeen, 0.0);
    for (const double share : {0.0, 0.5, 0.93, 1.0, 1.07, 1.4}) {
        std::vector<double> expectedMm = depthsAlongView(eye);
        for (double& mm : expectedMm) mm *= share;
        const ReferenceReprojection seen =
            share == 0.0 ? reproject(push, picture) : reproject(push, picture, expectedMm);
        for (std::size_t i = 0; i < picture.lights.size(); ++i) {
            ASSERT_NEAR(seen.weights[i], 1.0, 1e-5) << i << ", " << share;  // of 1e-6 against dividing by 0
            for (int k = 0; k < 4; ++k)
                ASSERT_NEAR(seen.lights[i][k], picture.lights[i][k], 1e-5) << i << ", " << share;
        }
    }
}

// What it says is so; and it says much.
TEST(Reproject, AnotherEyeSeesWhatIsThere) {
    const Camera before = cameraAt({0, -420, 0});
    const ReferenceCapture picture = captureOf(before, kSize);
    struct Case {
        Camera now;
        double leastKnown;  // of the pixels
    };
    for (const Case& c : {Case{cameraAt({1, -420, 0}), 0.97}, Case{cameraAt({5, -420, 3}), 0.94},
                          Case{cameraAt({-20, -420, 10}), 0.84}, Case{cameraAt({0, -380, 0}), 0.93},
                          Case{cameraAt({0, -470, 0}), 0.80}, Case{cameraAt({60, -410, 0}), 0.70},
                          // Turned by 1 and 5 degrees about itself.
                          Case{cameraAt({0, -420, 0}, {7.3, 0, 0}), 0.94},
                          Case{cameraAt({0, -420, 0}, {0, 0, 36.7}), 0.80}}) {
        const ReferenceReprojection seen = reprojected(picture, before, c.now);
        const Comparison found = compare(seen, c.now);
        const auto pixels = double((kSize.x - 2) * (kSize.y - 2));
        EXPECT_GT(double(found.known), c.leastKnown * pixels) << c.now.positionMm.x;
        EXPECT_LE(double(found.wrong), 0.002 * pixels) << c.now.positionMm.x;
        EXPECT_EQ(found.through, 0u) << c.now.positionMm.x;
        EXPECT_LT(found.meanOff, 0.02) << c.now.positionMm.x;
    }
}

// Behind the ball nothing was seen: a rubber sheet would put something there.
TEST(Reproject, WhatWasHiddenIsNotKnown) {
    const Camera before = cameraAt({0, -420, 0});
    const Camera now = cameraAt({60, -410, 0});
    const ReferenceReprojection seen = reprojected(captureOf(before, kSize), before, now);
    const std::vector<glm::dvec3> rays = raysOf(now, kSize);
    std::size_t hidden = 0;
    std::size_t claimed = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Scene::Seen here = Scene::from(now.positionMm, rays[i]);
        if (here.depthMm < 0.0) continue;
        const glm::dvec3 p = now.positionMm + rays[i] * here.depthMm;
        // Also a pixel to each side: on a rim both are seen.
        bool isHidden = true;
        for (const double x : {-1.0, 0.0, 1.0}) {
            const glm::dvec3 towards = p - before.positionMm;
            const glm::dvec3 aside = x * glm::dvec3(0.0025 * glm::length(towards), 0.0, 0.0);
            const double wasAt = Scene::from(before.positionMm, glm::normalize(towards + aside)).depthMm;
            isHidden = isHidden && glm::length(towards) > wasAt + 20.0;
        }
        if (!isHidden) continue;
        ++hidden;
        claimed += seen.weights[i] > 0.5 ? 1 : 0;
    }
    EXPECT_GT(hidden, 50u);
    EXPECT_LT(double(claimed), 0.05 * double(hidden));
}

TEST(Reproject, WhatIsUncertainCountsForLessTheMoreItMoves) {
    const Camera before = cameraAt({0, -420, 0});
    ReferenceCapture picture = captureOf(before, kSize);
    for (glm::dvec2& depth : picture.depths) depth.y = 60.0;
    const auto meanWeight = [&](const Camera& now) {
        const ReferenceReprojection seen = reprojected(picture, before, now);
        double sum = 0.0;
        for (const double weight : seen.weights) sum += weight;
        return sum / double(seen.weights.size());
    };
    const double still = meanWeight(before);
    const double little = meanWeight(cameraAt({20, -420, 0}));
    const double much = meanWeight(cameraAt({60, -420, 0}));
    EXPECT_NEAR(still, 1.0, 1e-12);
    EXPECT_GT(little, 0.3);
    EXPECT_LT(little, 0.97);
    EXPECT_LT(much, 0.2);
}

TEST(Reproject, ItsEdgeFadesWithoutAStep) {
    const Camera eye = cameraAt({0, -420, 0});
    const ReferenceReprojection seen = reprojected(captureOf(eye, kSize), eye, eye, 0.2);
    const auto at = [&](int x, int y) { return seen.weights[std::size_t(y) * kSize.x + std::size_t(x)]; };
    EXPECT_LT(at(0, 60), 0.01);
    EXPECT_LT(at(80, 0), 0.01);
    EXPECT_EQ(at(80, 60), 1.0);
    double before = 0.0;
    for (int x = 0; x < kSize.x / 2; ++x) {
        EXPECT_GE(at(x, 60), before);
        EXPECT_LT(at(x, 60) - before, 0.06);  // 32 pixels, steepest in the middle: 1.5 / 32
        before = at(x, 60);
    }
}

// All that has weight lies in it, and not much else.
TEST(Reproject, ItsRegionHoldsAllThatIsKnown) {
    Camera before = cameraAt({0, -420, 0});
    before.verticalFovDeg = 12.0;
    const ReferenceCapture picture = captureOf(before, kSize);
    for (const Camera& now :
         {cameraAt({0, -420, 0}), cameraAt({30, -420, 20}), cameraAt({0, -420, 0}, {90, 0, 30}),
          cameraAt({0, -250, 0}), cameraAt({-300, -300, 100}), cameraAt({0, 420, 0}),
          cameraAt({0, -420, 0}, {0, -900, 0}), cameraAt({10, -5, 0}, {0, 50, 0})}) {
        const ReferenceReprojection seen = reprojected(picture, before, now, 0.1);
        const PixelRegion region = reprojectedRegion(before, kSize, now, kSize, kSeen);
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const bool isIn = x >= region.firstPx.x && y >= region.firstPx.y &&
                                  x < region.firstPx.x + region.sizePx.x &&
                                  y < region.firstPx.y + region.sizePx.y;
                if (isIn) continue;
                ASSERT_EQ(seen.weights[std::size_t(y) * kSize.x + std::size_t(x)], 0.0) << x << y;
            }
        }
    }
    const PixelRegion same = reprojectedRegion(before, kSize, cameraAt({0, -420, 0}), kSize, kSeen);
    EXPECT_LT(same.sizePx.x * same.sizePx.y, 0.25 * kSize.x * kSize.y);
    EXPECT_EQ(
        reprojectedRegion(before, kSize, cameraAt({0, -420, 0}, {420, 0, 0}), kSize, kSeen).sizePx.x *
            reprojectedRegion(before, kSize, cameraAt({0, -420, 0}, {420, 0, 0}), kSize, kSeen).sizePx.y,
        0);
}

// Depths of splats spare the search, and change next to nothing.
TEST(Reproject, SplatsTellWhereToSeek) {
    const Camera before = cameraAt({0, -420, 0});
    const ReferenceCapture picture = captureOf(before, kSize);
    for (const Camera& now : {cameraAt({5, -420, 3}), cameraAt({-20, -430, 10}), cameraAt({60, -410, 0})}) {
        const auto push = *reprojectionOf(before, kSize, now, kSize, kSeen, 0.0);
        const ReferenceReprojection without = reproject(push, picture);
        const ReferenceReprojection with = reproject(push, picture, depthsAlongView(now));
        std::size_t off = 0;
        for (std::size_t i = 0; i < with.weights.size(); ++i)
            off += std::abs(with.weights[i] - without.weights[i]) > 0.1 ||
                           glm::length(with.lights[i] - without.lights[i]) * without.weights[i] > 0.1
                       ? 1
                       : 0;
        EXPECT_LT(double(off), 0.02 * double(with.weights.size())) << now.positionMm.x;
        const Comparison found = compare(with, now);
        EXPECT_LE(double(found.wrong), 0.002 * double(with.weights.size())) << now.positionMm.x;
        EXPECT_EQ(found.through, 0u) << now.positionMm.x;
    }
}

// Where splats show another depth than what was traced has, that is found as without them.
TEST(Reproject, SplatsThatAreWrongHideNothing) {
    const Camera before = cameraAt({0, -420, 0});
    const ReferenceCapture picture = captureOf(before, kSize);
    for (const Camera& now : {cameraAt({0, -420, 0.5}), cameraAt({5, -420, 3}), cameraAt({-20, -430, 10})}) {
        const auto push = *reprojectionOf(before, kSize, now, kSize, kSeen, 0.0);
        const ReferenceReprojection without = reproject(push, picture);
        for (const double share : {0.8, 1.25}) {
            std::vector<double> expectedMm = depthsAlongView(now);
            for (double& mm : expectedMm) mm *= share;
            const ReferenceReprojection with = reproject(push, picture, expectedMm);
            std::size_t less = 0;
            for (std::size_t i = 0; i < with.weights.size(); ++i)
                less += with.weights[i] < without.weights[i] - 0.1 ? 1 : 0;
            EXPECT_LT(double(less), 0.02 * double(with.weights.size())) << now.positionMm.z << ", " << share;
            EXPECT_EQ(compare(with, now).through, 0u) << now.positionMm.z << ", " << share;
        }
    }
}

class ReprojectionOnDevice : public gpu::SharedDeviceTest {
  protected:
    struct Seen {
        std::vector<glm::vec4> lights;
        std::vector<float> weights;
    };
    static Seen onDevice(const ReferenceCapture& picture, const Camera& before, const Camera& now,
                         const glm::ivec2& sizePx = kSize, double edgeFade = 0.1,
                         const std::vector<double>& expectedMm = {}) {
        std::vector<glm::vec4> lights(picture.lights.begin(), picture.lights.end());
        std::vector<glm::vec2> depths(picture.depths.begin(), picture.depths.end());
        CapturedPicture captured{
            .camera = before,
            .sizePx = kSize,
            .lights = std::move(*splat::DevicePicture::upload(device(), "lights", kSize.x, kSize.y, lights)),
            .depths = std::move(*makeTexels(device(), "depths", VK_FORMAT_R32G32_SFLOAT, depths.size())),
            .variances = std::move(*gpu::Buffer::create(device(), {.bytes = depths.size() * sizeof(float)})),
            .trusts = std::move(*makeTexels(device(), "trusts", VK_FORMAT_R32_SFLOAT, depths.size()))};
        EXPECT_TRUE(gpu::uploadTo<glm::vec2>(captured.depths.buffer(), depths).ok());
        std::vector<float> trusts(picture.trusts.begin(), picture.trusts.end());
        trusts.resize(depths.size(), 1.0f);
        EXPECT_TRUE(gpu::uploadTo<float>(captured.trusts.buffer(), trusts).ok());
        auto reprojection = Reprojection::create(device());
        // As a rasterizer leaves them: three quarters of a pixel are covered, or nothing.
        std::optional<DrawnSplats> splats;
        std::vector<glm::vec4> coverage(expectedMm.size());
        std::vector<float> depthSums(expectedMm.size());
        for (std::size_t i = 0; i < expectedMm.size(); ++i) {
            coverage[i].w = expectedMm[i] > 0.0 ? 0.75f : 0.0f;
            depthSums[i] = coverage[i].w * float(expectedMm[i]);
        }
        std::optional<splat::DevicePicture> drawn;
        std::optional<gpu::Buffer> sums;
        if (!expectedMm.empty()) {
            drawn =
                std::move(*splat::DevicePicture::upload(device(), "splats", sizePx.x, sizePx.y, coverage));
            sums = std::move(*gpu::Buffer::create(device(), {.bytes = depthSums.size() * sizeof(float)}));
            EXPECT_TRUE(gpu::uploadTo<float>(*sums, depthSums).ok());
            splats = DrawnSplats{&*drawn, &*sums};
        }
        const auto seen = reprojection->reproject(captured, now, sizePx, kSeen, edgeFade, splats);
        EXPECT_TRUE(seen.ok());
        return {*gpu::read<glm::vec4>(seen->lights->buffer()), *gpu::read<float>(seen->weights->buffer())};
    }
};

TEST_F(ReprojectionOnDevice, IsThatOfTheReference) {
    const Camera before = cameraAt({0, -420, 0});
    ReferenceCapture picture = captureOf(before, kSize);
    for (std::size_t i = 0; i < picture.depths.size(); i += 3) picture.depths[i].y = 7.0;
    // Trust has soft borders.
    for (std::size_t i = 0; i < picture.lights.size(); ++i)
        picture.trusts.push_back(0.5 + 0.5 * std::sin(0.1 * double(i % std::size_t(kSize.x))));
    for (const Camera& now : {before, cameraAt({5, -420, 3}), cameraAt({-20, -430, 10}),
                              cameraAt({0, -420, 0}, {7.3, 0, 0}), cameraAt({200, -300, 0})}) {
        for (const std::vector<double>& depths : {std::vector<double>(), depthsAlongView(now)}) {
            ReferenceReprojection expected =
                reproject(*reprojectionOf(before, kSize, now, kSize, kSeen, 0.1), picture, depths);
            expected.weights = feather(kSize, expected.weights);
            for (std::size_t i = 0; i < expected.weights.size(); ++i)
                expected.weights[i] *= expected.trusts[i];
            const Seen seen = onDevice(picture, before, now, kSize, 0.1, depths);
            std::size_t off = 0;
            for (std::size_t i = 0; i < expected.weights.size(); ++i) {
                const double weightOff = std::abs(double(seen.weights[i]) - expected.weights[i]);
                const double lightOff = glm::length(glm::dvec4(seen.lights[i]) - expected.lights[i]) *
                                        std::min(expected.weights[i], double(seen.weights[i]));
                off += weightOff > 0.02 || lightOff > 0.02 ? 1 : 0;
            }
            // Where a step lies on an edge of the height field, rounding decides on which side.
            EXPECT_LT(double(off), 0.004 * double(expected.weights.size())) << now.positionMm.x;
        }
    }
}

// Whatever it is told, it is a number, and weights are from 0 to 1.
TEST_F(ReprojectionOnDevice, HoldsAtTheExtremes) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const Camera before = cameraAt({0, -420, 0});
    const ReferenceCapture good = captureOf(before, kSize);
    const auto expectSane = [&](const Seen& seen, const char* what) {
        for (std::size_t i = 0; i < seen.weights.size(); ++i) {
            ASSERT_GE(seen.weights[i], 0.0f) << what;
            ASSERT_LE(seen.weights[i], 1.0f) << what;
            if (seen.weights[i] <= 0.0f) continue;
            for (int k = 0; k < 4; ++k) ASSERT_TRUE(std::isfinite(seen.lights[i][k])) << what;
        }
    };
    expectSane(onDevice(good, before, cameraAt({0, 420, 0})), "from behind");
    expectSane(onDevice(good, before, cameraAt({0, -1, 0}, {0, 50, 0})), "from inside");
    expectSane(onDevice(good, before, cameraAt({0, -4.2e8, 0})), "from a million times as far");
    expectSane(onDevice(good, before, cameraAt({1e-30, -420, 0})), "a denormal step aside");
    expectSane(onDevice(good, before, cameraAt({0, -420, 0}, {0, -900, 0})), "the other way");
    expectSane(onDevice(good, before, before, {1, 1}), "one pixel");
    expectSane(onDevice(good, before, cameraAt({3, -420, 0}), {1, 700}), "one column");
    ReferenceCapture nothing = good;
    for (glm::dvec2& depth : nothing.depths) depth = {-1.0, 0.0};
    for (glm::dvec4& light : nothing.lights) light = glm::dvec4(0.0);
    const Seen empty = onDevice(nothing, before, cameraAt({9, -420, 0}));
    expectSane(empty, "nothing to be seen");
    for (const glm::vec4& light : empty.lights) ASSERT_EQ(light, glm::vec4(0.0f));
    for (const double bad : {double(nan), infinity, -infinity, 0.0, 1e-310, 1e30}) {
        ReferenceCapture broken = good;
        for (std::size_t i = 0; i < broken.depths.size(); i += 2) broken.depths[i].x = bad;
        expectSane(onDevice(broken, before, cameraAt({9, -420, 0})), "depths");
        broken = good;
        for (std::size_t i = 0; i < broken.depths.size(); i += 2) broken.depths[i].y = std::abs(bad);
        expectSane(onDevice(broken, before, cameraAt({9, -420, 0})), "uncertainty");
    }
    EXPECT_EQ(reprojectionOf(before, kSize, cameraAt({nan, 0, 0}), kSize, kSeen, 0.1).error().code,
              ErrorCode::usage);
}

}  // namespace
}  // namespace macula::hybrid
