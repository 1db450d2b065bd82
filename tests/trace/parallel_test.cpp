// Parallel rays where the answer is a formula. The device is held to the same maths in
// parallel_device_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "base/phantom.h"
#include "pipeline/trace/guide_pixel.h"
#include "pipeline/trace/reference_tracer.h"
#include "trace/denoise_pictures.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

const Environment kSky = Environment::constant(glm::vec3(1.0f));

View parallelView(const glm::dvec3& positionMm, const glm::dvec3& targetMm, double heightMm, int width,
                  int height) {
    Camera camera;
    camera.positionMm = positionMm;
    camera.targetMm = targetMm;
    camera.parallelHeightMm = heightMm;
    return {.camera = camera, .width = width, .height = height};
}

// The phantom's body in air, opaque.
struct Body {
    std::shared_ptr<const Volume> volume = std::make_shared<const Volume>(
        phantom::make({.size = {128, 112, 80}, .spacingMm = {2.4, 2.4, 3.75}}));
    Medium medium;
    ReferenceTracer tracer;

    Body() : medium(mediumOf(*volume)), tracer(*volume, medium, kSky) {}

    static Medium mediumOf(const Volume& volume) {
        TransferFunction skin = scenes::homogeneous(20.0);
        skin.opacity = {{-480, 0.0}, {-480, 0.5}};  // halfway from air to fat
        return makeMedium(volume, makeBrickGrid(volume), skin);
    }
    std::vector<glm::dvec4> cast(const View& view) const {
        const auto params = makeTraceParams(*volume, medium, kSky, view, {.look = Look::dvr});
        return tracer.cast(*params, {}, Precision::twofold, 0, 1);
    }
    // How much of a picture of 1 mm for a pixel it covers, along its longer side.
    double coveredMm(View view) const {
        view.camera = standingBefore(view.camera, volume->worldBox());
        const bool isWide = view.width > view.height;
        double covered = 0.0;
        const auto pixels = cast(view);
        for (int i = 0; i < std::max(view.width, view.height); ++i) {
            const int x = isWide ? i : view.width / 2;
            const int y = isWide ? view.height / 2 : i;
            covered += pixels[std::size_t(y * view.width + x)].a;
        }
        return covered;
    }
};

const Body& body() {
    static const Body only;
    return only;
}

// The skin is an elliptic cylinder of 276 x 208 x 264 mm about (0, 5, 0), cut flat above and below.
TEST(Parallel, ThePhantomIsAsWideAsItIs) {
    const glm::dvec3 middle(0, 5, 0);
    // Wherever the camera stands, and were it within the body.
    for (const double distanceMm : {10.0, 300.0, 5000.0}) {
        SCOPED_TRACE(distanceMm);
        const glm::dvec3 front = middle + glm::dvec3(0, -distanceMm, 0);
        EXPECT_NEAR(body().coveredMm(parallelView(front, middle, 4, 320, 4)), 276.0, 2.0);
        // Within a slice and a pixel: the cut lies within slices of 3.75 mm, of which the spine has a fifth.
        EXPECT_NEAR(body().coveredMm(parallelView(front, middle, 320, 4, 320)), 264.0, 4.75);
        const glm::dvec3 left = middle + glm::dvec3(distanceMm, 0, 0);
        EXPECT_NEAR(body().coveredMm(parallelView(left, middle, 4, 320, 4)), 208.0, 2.0);
    }
    // At every depth the same: the target may lie anywhere along the view.
    EXPECT_NEAR(body().coveredMm(parallelView({0, -900, 0}, {0, -400, 0}, 4, 320, 4)), 276.0, 2.0);
    // Half the height of the picture in mm is twice as large.
    EXPECT_NEAR(body().coveredMm(parallelView({0, -900, 0}, middle, 8, 320, 4)), 138.0, 2.0);
}

// An eye at the same place sees near things larger: so the pictures are not the same by chance.
TEST(Parallel, IsNotWhatAnEyeSees) {
    View eye = parallelView({0, -400, 0}, {0, 5, 0}, 320, 320, 320);
    const auto straight = body().cast(eye);
    eye.camera = inPerspective(eye.camera);
    eye.camera.verticalFovDeg = glm::degrees(2.0 * std::atan(160.0 / 405.0));
    eye.camera.positionMm = {0, -400, 0};
    int different = 0;
    const auto seen = body().cast(eye);
    for (std::size_t i = 0; i < seen.size(); ++i) different += std::abs(seen[i].a - straight[i].a) > 0.5;
    EXPECT_GT(different, 1000);
}

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

std::vector<GuideOf<double>> guidesOf(const Volume& volume, const View& now, const View& before) {
    TransferFunction step = scenes::homogeneous(50.0);
    step.opacity = {{1000, 0.0}, {1000, 0.5}};
    const Medium medium = makeMedium(volume, makeBrickGrid(volume), step);
    const auto params = makeTraceParams(volume, medium, kSky, now, {});
    return ReferenceTracer(volume, medium, kSky).guides(*params, *guidePush(now, before), Precision::twofold);
}

// Where the ray through the middle of a pixel begins: right of the picture is the basis' right, and its first
// row is on top.
glm::dvec3 beginMm(const View& view, double x, double y) {
    const CameraBasis axes = *basis(view.camera);
    const double mm = view.camera.parallelHeightMm / view.height;
    return view.camera.positionMm + axes.right * (x - 0.5 * view.width) * mm +
           axes.up * (0.5 * view.height - y) * mm;
}

// The ball lies to one side and below, so that a mirrored or rolled picture has it elsewhere.
TEST(Parallel, ARayGoesStraightThroughTheMiddleOfItsPixel) {
    const double radius = 14.0;
    const auto volume = ball(radius, 100.0);
    const View view = parallelView({47, -300, 35}, {-8, 3, 9}, 64, 80, 64);
    const CameraBasis axes = *basis(view.camera);
    const auto pixels = guidesOf(*volume, view, view);
    int hits = 0;
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const auto& guide = pixels[std::size_t(y * view.width + x)];
            const glm::dvec3 begin = beginMm(view, x + 0.5, y + 0.5);
            const double along = -glm::dot(axes.forward, begin);
            const double miss = glm::length(begin + along * axes.forward);
            if (miss > radius + 1) {
                EXPECT_LT(guide.depthMm, 0.0) << x << ", " << y;
            }
            if (miss > 0.8 * radius) continue;
            ++hits;
            // To half a voxel: the ray is marched in steps.
            EXPECT_NEAR(guide.depthMm, along - std::sqrt(radius * radius - miss * miss), 0.75);
            const glm::dvec3 normal = glm::normalize(begin + guide.depthMm * axes.forward);
            EXPECT_GT(glm::dot(guide.normal, normal), std::cos(glm::radians(4.0))) << x << ", " << y;
            EXPECT_NEAR(glm::length(guide.motion), 0.0, 1e-3);
            EXPECT_NEAR(guide.beforeMm, guide.depthMm, 1e-3);
        }
    }
    EXPECT_NEAR(hits, 3.14159 * 0.64 * radius * radius, 20.0);  // a pixel is a square millimetre
}

TEST(Parallel, MotionLeadsToTheSamePointInTheViewBefore) {
    const auto volume = ball(14.0, 100.0);
    const View now = parallelView({60, -300, 40}, {0, 0, 0}, 40, 33, 33);
    for (const double beforeHeightMm : {55.0, 0.0}) {  // of the second an eye
        View before = parallelView({80, -260, 20}, {1, 2, -3}, beforeHeightMm, 33, 33);
        before.camera.verticalFovDeg = 25;
        const CameraBasis axes = *basis(before.camera);
        const double half = std::tan(glm::radians(12.5));
        const auto pixels = guidesOf(*volume, now, before);
        int hits = 0;
        for (int y = 0; y < 33; ++y) {
            for (int x = 0; x < 33; ++x) {
                const auto& guide = pixels[std::size_t(y * 33 + x)];
                if (guide.depthMm < 0.0) continue;
                ++hits;
                const glm::dvec3 point =
                    beginMm(now, x + 0.5, y + 0.5) + guide.depthMm * basis(now.camera)->forward;
                const glm::dvec2 p = guide.motion + glm::dvec2(x + 0.5, y + 0.5);
                const glm::dvec3 eyeRay = glm::normalize(
                    axes.forward + half * (axes.right * (2 * p.x / 33 - 1) + axes.up * (1 - 2 * p.y / 33)));
                const glm::dvec3 found = isParallel(before.camera)
                                             ? beginMm(before, p.x, p.y) + guide.beforeMm * axes.forward
                                             : before.camera.positionMm + guide.beforeMm * eyeRay;
                EXPECT_LT(glm::distance(point, found), 2e-3);
            }
        }
        EXPECT_GT(hits, 100);
    }
}

// What the filter takes for the width of a pixel does not grow with the depth.
TEST(Parallel, APixelIsAsWideAtEveryDepth) {
    for (const double depthMm : {20.0, 500.0}) {
        const TruePicture picture(8, 8, [=](int, int) {
            TruePixel pixel{};
            pixel.depthMm = depthMm;
            return pixel;
        });
        shared::DenoisePush push = picture.push();
        push.parallelMm = 100.0f;
        const DenoiseGuides guides = picture.guides();
        std::vector<glm::dvec4> masses;
        const DenoiseRecord record = denoiseGather(push, picture.film(4, 1), guides, guides, {});
        const DenoiseState state = denoisePrepare(push, record, guides, masses);
        EXPECT_NEAR(state.noises[27].z, 0.5 * 0.001 * 100.0, 1e-6);
    }
}

TEST(Parallel, WhatIsNoPictureIsRefused) {
    const View good = parallelView({0, -400, 0}, {0, 0, 0}, 300, 8, 8);
    EXPECT_TRUE(makeTraceParams(*body().volume, body().medium, kSky, good, {}).ok());
    for (const double wrong : {-1.0, 1e-9, 1e12, std::nan(""), double(INFINITY)}) {
        View bad = good;
        bad.camera.parallelHeightMm = wrong;
        const auto params = makeTraceParams(*body().volume, body().medium, kSky, bad, {});
        ASSERT_FALSE(params.ok()) << wrong;
        EXPECT_EQ(params.error().code, ErrorCode::usage);
    }
    EXPECT_FALSE(fovealWindow(good, {0.0, 0.0}).ok());
}

}  // namespace
}  // namespace macula::trace
