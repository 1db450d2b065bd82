// Two tracers of one scene: a view of their own each, and one copy of what is shown.
#include <gtest/gtest.h>

#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"

namespace macula::trace {
namespace {

constexpr glm::ivec3 kVoxels{24, 20, 16};

class SameScene : public DeviceTest {
  protected:
    const std::shared_ptr<const Volume> volume_ =
        scenes::volumeOf(kVoxels, scenes::grid(glm::dvec3(1.0), kVoxels), scenes::blob(kVoxels, 1000));
    const TransferFunction function_ = scenes::ramp(100, 500, 0.6, 1.0);
    const Environment lights_ = Environment::constant(glm::vec3(1.0f));
    const View view_ = scenes::lookAt(*volume_);

    PathTracer first() { return tracer(volume_, function_, lights_, view_, {}); }
    View other() const {
        View view = view_;
        view.camera.positionMm = -view.camera.positionMm;
        view.width = 40;
        return view;
    }
    static std::vector<glm::vec4> picture(PathTracer& t) { return t.readback().value().radiance; }
};

TEST_F(SameScene, AnotherViewLeavesThePictureOfTheFirstAloneAndTracesWhatItWouldByItself) {
    PathTracer a = first();
    ASSERT_TRUE(*a.trace(4));
    const std::vector<glm::vec4> before = picture(a);
    auto b = a.ofSameScene();
    ASSERT_TRUE(b.ok()) << b.error().message;
    const Settings settings{.seed = 3, .denoising = Denoising::little};
    ASSERT_TRUE(b->setSettings(settings).ok());
    ASSERT_TRUE(b->setView(other()).ok());
    ASSERT_TRUE(*b->trace(2));
    EXPECT_EQ(a.statistics()->samplesPerPixel, 4u);
    EXPECT_EQ(picture(a), before);
    PathTracer alone = tracer(volume_, function_, lights_, other(), settings);
    ASSERT_TRUE(*alone.trace(2));
    EXPECT_EQ(picture(*b), picture(alone));
    // In turns, each goes on with its own.
    ASSERT_TRUE(*a.trace(4));
    PathTracer whole = first();
    ASSERT_TRUE(*whole.trace(8));
    EXPECT_EQ(picture(a), picture(whole));
}

TEST_F(SameScene, WhatOneIsToldHoldsForAllAndNoSampleOfBeforeStays) {
    PathTracer a = first();
    PathTracer b = *a.ofSameScene();
    ASSERT_TRUE(b.setView(view_).ok());
    ASSERT_TRUE(*b.trace(3));
    ASSERT_TRUE(*a.trace(3));
    Clip half;
    half.planes = {{glm::dvec3(1, 0, 0), 0.0}};
    ASSERT_TRUE(a.scene().setClip(half).ok());
    EXPECT_EQ(b.statistics()->samplesPerPixel, 0u);
    ASSERT_TRUE(*b.trace(2));
    EXPECT_EQ(b.statistics()->samplesPerPixel, 2u);
    PathTracer alone = first();
    ASSERT_TRUE(alone.scene().setClip(half).ok());
    ASSERT_TRUE(*alone.trace(2));
    EXPECT_EQ(picture(b), picture(alone));
    // The box of what is seen is that of the half.
    EXPECT_NEAR(b.seenMm()->low.x, 0.0, 9.0);
    EXPECT_LT(first().seenMm()->low.x, -8.0);
}

// A projection has other tables; whoever looks at matter after that has its own again.
TEST_F(SameScene, LooksOfDifferentKindsTakeTurns) {
    PathTracer a = first();
    ASSERT_TRUE(*a.trace(2));
    const std::vector<glm::vec4> matter = picture(a);
    PathTracer b = *a.ofSameScene();
    ASSERT_TRUE(b.setSettings({.look = Look::mip}).ok());
    ASSERT_TRUE(b.setView(view_).ok());
    ASSERT_TRUE(*b.trace(1));
    EXPECT_EQ(b.seenMm().error().code, ErrorCode::usage);
    EXPECT_EQ(a.statistics()->samplesPerPixel, 0u);
    ASSERT_TRUE(*a.trace(2));
    EXPECT_EQ(picture(a), matter);
}

// The filter in pieces: the same picture, and interrupted it is neither shown as done nor begun anew.
TEST_F(SameScene, APictureIsDevelopedPieceByPiece) {
    const Settings settings{.bounces = 1, .denoising = Denoising::on};
    View large = view_;
    large.width = 640;
    large.height = 480;
    PathTracer a = tracer(volume_, function_, lights_, large, settings);
    ASSERT_TRUE(*a.trace(1));
    PathTracer b = tracer(volume_, function_, lights_, large, settings);
    ASSERT_TRUE(*b.trace(1));
    int pieces = 0;
    while (true) {
        const auto done = a.develop([] { return false; });
        ASSERT_TRUE(done.ok()) << done.error().message;
        ++pieces;
        if (*done) break;
    }
    EXPECT_GT(pieces, device()->isCpu() ? 10 : 1);  // a graphics card gets several stages at a time
    EXPECT_EQ(picture(a), picture(b));
    // Samples that come meanwhile are filtered, too.
    ASSERT_TRUE(*a.trace(1));
    EXPECT_FALSE(*a.develop([] { return false; }));
    ASSERT_TRUE(*a.trace(1));
    ASSERT_TRUE(*b.trace(2));
    EXPECT_TRUE(*a.develop([] { return true; }));
    EXPECT_EQ(picture(a), picture(b));
}

}  // namespace
}  // namespace macula::trace
