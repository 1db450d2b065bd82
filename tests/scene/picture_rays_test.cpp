// From places in a picture to rays, and back.
#include "scene/camera/picture_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace macula::scene {
namespace {

// Anterior, the patient's left at the right of the picture.
Camera fromAnterior() {
    return {.positionMm = {0, -1000, 0}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}, .verticalFovDeg = 90};
}

TEST(PictureRays, NothingIsMirrored) {
    const auto rays = PictureRays::of(fromAnterior(), 2.0);
    ASSERT_TRUE(rays);
    const auto left = rays->placeOf({1000, 0, 0});
    ASSERT_TRUE(left);
    EXPECT_NEAR(left->x, 0.5, 1e-12) << "the picture is two high widths wide";
    EXPECT_NEAR(left->y, 0.0, 1e-12);
    EXPECT_NEAR(rays->placeOf({0, 0, 500})->y, 0.5, 1e-12) << "the head is up";
    EXPECT_NEAR(rays->placeOf({0, 1000, 500})->y, 0.25, 1e-12) << "twice as far";
}

TEST(PictureRays, APlaceIsWhereItsRayGoes) {
    const Camera oblique{
        .positionMm = {300, -700, 450}, .targetMm = {10, 20, -30}, .up = {0.1, 0, 1}, .verticalFovDeg = 37};
    const auto rays = PictureRays::of(oblique, 1.6);
    ASSERT_TRUE(rays);
    for (const glm::dvec2 place : {glm::dvec2(0, 0), glm::dvec2(-1, 1), glm::dvec2(0.3, -0.8)}) {
        for (const double mm : {0.1, 800.0, 1e5}) {
            const auto back = rays->placeOf(rays->through(place).at(mm));
            ASSERT_TRUE(back);
            EXPECT_LT(glm::distance(*back, place), 1e-9);
        }
    }
    const glm::dvec3 a(5, 6, 7);
    const glm::dvec3 b(-50, 60, 170);
    EXPECT_LT(glm::distance(rays->homogeneous(a) + rays->homogeneousStep(b - a), rays->homogeneous(b)), 1e-9);
}

TEST(PictureRays, WhatIsBehindTheEyeHasNoPlace) {
    const auto rays = PictureRays::of(fromAnterior(), 1.0);
    EXPECT_FALSE(rays->placeOf({0, -1000, 0}));
    EXPECT_FALSE(rays->placeOf({10, -1001, 5}));
    EXPECT_FALSE(rays->placeOf({std::numeric_limits<double>::quiet_NaN(), 0, 0}));
    EXPECT_FALSE(PictureRays::of({.positionMm = {1, 1, 1}, .targetMm = {1, 1, 1}}, 1.0));
    EXPECT_FALSE(PictureRays::of(fromAnterior(), 0.0));
    EXPECT_FALSE(PictureRays::of(fromAnterior(), std::numeric_limits<double>::quiet_NaN()));
}

// Twice as far is as large, and what is behind where they begin is seen as well.
TEST(PictureRays, OfAParallelCameraAreParallel) {
    Camera camera = fromAnterior();
    camera.parallelHeightMm = 500.0;
    const auto rays = PictureRays::of(camera, 2.0);
    ASSERT_TRUE(rays);
    for (const double y : {-2000.0, -1000.0, 0.0, 3000.0}) {
        const auto left = rays->placeOf({250, y, 0});
        ASSERT_TRUE(left);
        EXPECT_NEAR(left->x, 0.5, 1e-12) << "the patient's left is at the right";
        EXPECT_NEAR(rays->placeOf({0, y, 125})->y, 0.5, 1e-12) << "the head is up";
    }
    for (const glm::dvec2 place : {glm::dvec2(0, 0), glm::dvec2(-1, 1), glm::dvec2(0.3, -0.8)}) {
        const PictureRay ray = rays->through(place);
        EXPECT_LT(glm::distance(ray.direction, {0, 1, 0}), 1e-12);
        for (const double mm : {-900.0, 0.0, 800.0}) {
            const auto back = rays->placeOf(ray.at(mm));
            ASSERT_TRUE(back);
            EXPECT_LT(glm::distance(*back, place), 1e-9);
        }
        const auto met = meets(ray, {0, -1500, 0}, {0, 1, 0});
        ASSERT_TRUE(met) << "behind its origin, which is no eye";
        EXPECT_NEAR(met->y, -1500.0, 1e-9);
        EXPECT_TRUE(nearestOnLine(ray, {0, -2000, 30}, {1, 0, 0}));
    }
    const glm::dvec3 a(5, 6, 7);
    const glm::dvec3 b(-50, 60, 170);
    EXPECT_LT(glm::distance(rays->homogeneous(a) + rays->homogeneousStep(b - a), rays->homogeneous(b)), 1e-9);
    EXPECT_FALSE(rays->placeOf({std::numeric_limits<double>::quiet_NaN(), 0, 0}));
}

TEST(PictureRays, FindWhereALineOrAPlaneIsMet) {
    const PictureRay ray{.originMm = {0, -1000, 0}, .direction = {0, 1, 0}};
    // A line along x, 30 mm above the ray: nearest where x is 0.
    const auto along = nearestOnLine(ray, {-40, 0, 30}, {1, 0, 0});
    ASSERT_TRUE(along);
    EXPECT_NEAR(*along, 40.0, 1e-9);
    EXPECT_FALSE(nearestOnLine(ray, {5, 0, 0}, {0, 1, 0})) << "parallel";
    EXPECT_FALSE(nearestOnLine(ray, {0, -2000, 0}, {1, 0, 0})) << "behind the eye";
    EXPECT_FALSE(nearestOnLine(ray, {0, 0, 0}, {0, 0, 0}));
    const auto met = meets(ray, {3, 50, 9}, {0, 1, 0});
    ASSERT_TRUE(met);
    EXPECT_LT(glm::distance(*met, {0, 50, 0}), 1e-9);
    EXPECT_FALSE(meets(ray, {3, 50, 9}, {1, 0, 0})) << "along the ray";
    EXPECT_FALSE(meets(ray, {0, -1001, 0}, {0, 1, 0})) << "behind the eye";
}

}  // namespace
}  // namespace macula::scene
