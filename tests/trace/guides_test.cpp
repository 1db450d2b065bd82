// Guides in double, where the answer is a formula. The device is held to them in guides_device_test.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/trace/guide_pixel.h"
#include "pipeline/trace/reference_tracer.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

std::vector<GuideOf<double>> guidesOf(const Volume& volume, const TransferFunction& function, const View& now,
                                      const View& before, Precision precision = Precision::twofold) {
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    const Medium medium = makeMedium(volume, makeBrickGrid(volume), function);
    const auto params = makeTraceParams(volume, medium, sky, now, {});
    return ReferenceTracer(volume, medium, sky).guides(*params, *guidePush(now, before), precision);
}

// Values that fall by `slope` per mm from 1000 on a ball of `radiusMm` about the origin, voxels of 1 x 1.5 x
// 2 mm.
std::shared_ptr<const Volume> ball(double radiusMm, double slope) {
    const glm::ivec3 size{48, 32, 24};
    const glm::dvec3 spacing(1.0, 1.5, 2.0);
    const glm::dvec3 first = -0.5 * spacing * (glm::dvec3(size) - 1.0);
    const glm::dmat4 toWorld = affine({spacing.x, 0, 0}, {0, spacing.y, 0}, {0, 0, spacing.z}, first);
    return scenes::volumeOf(size, toWorld, [=](int i, int j, int k) {
        const double mm = glm::length(first + spacing * glm::dvec3(i, j, k)) - radiusMm;
        return static_cast<std::uint16_t>(std::clamp(1000.0 - slope * mm, 0.0, 4000.0));
    });
}

View at(const glm::dvec3& positionMm, int pixels) {
    return {
        .camera = {.positionMm = positionMm, .targetMm = {0, 0, 0}, .up = {0, 0, 1}, .verticalFovDeg = 20},
        .width = pixels,
        .height = pixels};
}

TEST(Guides, OfASlabAreWhatTheFormulasSay) {
    const auto [volume, view] = scenes::slab(10.0, 4);
    const double perMm = 0.2;
    const double footprintMm = (3000 - 5 + std::log(2.0) / perMm) * 2 * std::tan(glm::radians(0.05)) / 4;
    const double confidence = 4 * footprintMm / (4 * footprintMm + std::log(3.0) / perMm);
    for (const auto& guide : guidesOf(*volume, scenes::homogeneous(perMm, 0.7), view, view)) {
        EXPECT_NEAR(guide.depthMm, 3000 - 5 + std::log(2.0) / perMm, 0.002);
        EXPECT_NEAR(guide.coverage, 1 - std::exp(-2.0), 1e-5);
        EXPECT_NEAR(guide.albedo.y, 0.7, 1e-6);
        EXPECT_NEAR(guide.confidence, confidence, 1e-3);
        EXPECT_EQ(guide.normal, glm::dvec3(0.0));  // all values are the same
        EXPECT_NEAR(glm::length(guide.motion), 0.0, 1e-4);
        EXPECT_NEAR(guide.beforeMm, guide.depthMm, 1e-3);
    }
    // Too thin for a depth: it is covered, it has a colour, and moves like its middle.
    for (const auto& guide : guidesOf(*volume, scenes::homogeneous(0.05, 0.7), view, view)) {
        EXPECT_LT(guide.depthMm, 0.0);
        EXPECT_EQ(guide.confidence, 0.0);
        EXPECT_NEAR(guide.coverage, 1 - std::exp(-0.5), 1e-5);
        EXPECT_NEAR(guide.albedo.x, 0.7, 1e-6);
        const double mean = 1 / 0.05 - 10 * std::exp(-0.5) / (1 - std::exp(-0.5));
        EXPECT_NEAR(guide.beforeMm, 3000 - 5 + mean, 0.02);
    }
}

TEST(Guides, OfABallHaveItsDepthAndNormal) {
    const double radius = 14.0;
    const auto volume = ball(radius, 100.0);
    TransferFunction step = scenes::homogeneous(50.0);
    step.opacity = {{1000, 0.0}, {1000, 0.5}};
    const View view = at({60, -300, 40}, 65);
    const auto pixels = guidesOf(*volume, step, view, view);
    const CameraBasis eye = *basis(view.camera);
    const double half = std::tan(glm::radians(10.0));
    int hits = 0;
    for (int y = 0; y < 65; ++y) {
        for (int x = 0; x < 65; ++x) {
            const auto& guide = pixels[std::size_t(y * 65 + x)];
            const glm::dvec3 ray = glm::normalize(eye.forward + half * (eye.right * (2 * (x + 0.5) / 65 - 1) +
                                                                        eye.up * (1 - 2 * (y + 0.5) / 65)));
            const double along = -glm::dot(ray, view.camera.positionMm);
            const double miss = glm::length(view.camera.positionMm + along * ray);
            if (miss > radius + 1) {
                EXPECT_LT(guide.depthMm, 0.0);
                EXPECT_EQ(guide.normal, glm::dvec3(0.0));
                EXPECT_LT(guide.beforeMm, 0.0);
            }
            if (miss > 0.8 * radius) continue;
            ++hits;
            EXPECT_NEAR(guide.depthMm, along - std::sqrt(radius * radius - miss * miss),
                        0.45);  // step, and chords
            const glm::dvec3 normal = glm::normalize(view.camera.positionMm + guide.depthMm * ray);
            EXPECT_GT(glm::dot(guide.normal, normal), std::cos(glm::radians(4.0))) << x << ", " << y;
            EXPECT_NEAR(glm::length(guide.normal), 1.0, 1e-6);
            EXPECT_GT(guide.confidence, 0.9);
            EXPECT_GT(guide.coverage, 0.99);
        }
    }
    EXPECT_GT(hits, 40);
}

// Motion and distance lead to the very point in the view before: its ray meets it there.
TEST(Guides, MotionLeadsToTheSamePointInTheViewBefore) {
    const auto volume = ball(14.0, 100.0);
    TransferFunction step = scenes::homogeneous(50.0);
    step.opacity = {{1000, 0.0}, {1000, 0.5}};
    const View now = at({60, -300, 40}, 33);
    View before = at({80, -260, 20}, 33);
    before.camera.targetMm = {1, 2, -3};
    before.camera.verticalFovDeg = 25;
    const CameraBasis eyeNow = *basis(now.camera);
    const CameraBasis eye = *basis(before.camera);
    const double half = std::tan(glm::radians(12.5));
    const double halfNow = std::tan(glm::radians(10.0));
    const auto pixels = guidesOf(*volume, step, now, before);
    int hits = 0;
    for (int y = 0; y < 33; ++y) {
        for (int x = 0; x < 33; ++x) {
            const auto& guide = pixels[std::size_t(y * 33 + x)];
            if (guide.depthMm < 0.0) continue;
            ++hits;
            const glm::dvec2 p = guide.motion + glm::dvec2(x + 0.5, y + 0.5);
            const glm::dvec3 ray = glm::normalize(
                eye.forward + half * (eye.right * (2 * p.x / 33 - 1) + eye.up * (1 - 2 * p.y / 33)));
            const glm::dvec3 point = before.camera.positionMm + guide.beforeMm * ray;
            const glm::dvec3 rayNow =
                glm::normalize(eyeNow.forward + halfNow * (eyeNow.right * (2 * (x + 0.5) / 33 - 1) +
                                                           eyeNow.up * (1 - 2 * (y + 0.5) / 33)));
            EXPECT_NEAR(glm::distance(point, now.camera.positionMm + guide.depthMm * rayNow), 0.0, 2e-3);
        }
    }
    EXPECT_GT(hits, 30);
}

// Under foveation too: with a gaze that moved, a picture of the same eye moves as the map says.
TEST(Guides, MotionFollowsTheMapOfAFoveatedView) {
    const auto volume = ball(14.0, 100.0);
    TransferFunction step = scenes::homogeneous(50.0);
    step.opacity = {{1000, 0.0}, {1000, 0.5}};
    View now = at({60, -300, 40}, 65);
    now.foveation = Foveation{.gaze = {0.1, -0.05}, .fieldDeg = 4, .magnification = 2};
    View before = now;
    before.foveation = {};
    // A still eye: the same point, hence the same ray, in the plain picture.
    int hits = 0;
    const auto pixels = guidesOf(*volume, step, now, before);
    const auto plain = guidesOf(*volume, step, before, before);
    for (int y = 0; y < 65; ++y) {
        for (int x = 0; x < 65; ++x) {
            const auto& guide = pixels[std::size_t(y * 65 + x)];
            if (guide.confidence < 0.9) continue;
            const glm::dvec2 p = guide.motion + glm::dvec2(x, y);
            const glm::ivec2 nearest(glm::round(p));
            if (glm::distance(glm::dvec2(nearest), p) > 0.15) continue;
            const auto& there = plain[std::size_t(nearest.y * 65 + nearest.x)];
            EXPECT_NEAR(there.depthMm, guide.depthMm, 1.5) << x << ", " << y;
            EXPECT_NEAR(guide.beforeMm, guide.depthMm, 1e-3);
            ++hits;
        }
    }
    EXPECT_GT(hits, 12);
    // And towards a foveated view: a round trip stays where it was.
    for (const auto& guide : guidesOf(*volume, step, now, now))
        EXPECT_NEAR(glm::length(guide.motion), 0.0, 1e-3);
}

TEST(Guides, WhatWasBehindTheEyeHasNoMotion) {
    const auto [volume, view] = scenes::slab(10.0, 4);
    View before = view;
    before.camera.positionMm = {0.1, 3000, 0.2};
    before.camera.targetMm = {0.1, 6000, 0.2};  // looks away
    for (const auto& guide : guidesOf(*volume, scenes::homogeneous(0.2), view, before)) {
        EXPECT_GT(guide.depthMm, 0.0);
        EXPECT_LT(guide.beforeMm, 0.0);
        EXPECT_EQ(guide.motion, glm::dvec2(0.0));
    }
}

TEST(Guides, OfNothingAreEmpty) {
    const auto volume = scenes::volumeOf({1, 1, 1}, glm::dmat4(1.0), [](int, int, int) { return 0; });
    for (const auto& guide :
         guidesOf(*volume, scenes::homogeneous(1.0), at({0, -10, 0}, 3), at({0, -10, 1}, 3))) {
        EXPECT_LT(guide.depthMm, 0.0);
        EXPECT_LT(guide.beforeMm, 0.0);
        EXPECT_EQ(guide.coverage, 0.0);
        EXPECT_EQ(guide.albedo, glm::dvec3(0.0));
        EXPECT_EQ(guide.motion, glm::dvec2(0.0));
    }
}

}  // namespace
}  // namespace macula::trace
