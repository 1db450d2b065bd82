// What is submitted where a headset takes more than two pictures: depths, what lenses hide, insets, the room.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "xr/scripted_room.h"

namespace macula::xr {
namespace {

using xr_script::Script;
using xr_script::SubmittedFrame;
using xr_script::SubmittedView;

class LayersTest : public ScriptedRoom {
  protected:
    void findModel() {
        for (int i = 0; i < 2000 && !view_->model().canBeDrawn(); ++i)
            expectOk(view_->model().work(20.0, [] { return true; }));
        ASSERT_TRUE(view_->model().canBeDrawn());
    }
    // So much larger than it is, with the marker straight ahead of who stands there.
    void openAround(double scale, double aheadM) {
        glm::dmat4 placed = stageFromWorldBefore({{0.0, 1.6, 0.0}, {1, 0, 0, 0}}, view_->seenMm());
        placed = glm::scale(placed, glm::dvec3(scale));
        placed[3] = glm::dvec4(glm::dvec3(0.0, 1.6, -aheadM) - glm::dmat3(placed) * markerMm(), 1.0);
        open(placed);
    }
    // The marker in the stage, as that eye sees it.
    glm::dvec3 markerFrom(const SubmittedView& view) const {
        return glm::inverse(view.pose.orientation) *
               (transformPoint(*headset_->placed(), markerMm()) - view.pose.positionM);
    }
    static glm::dvec2 placeIn(const SubmittedView& view, const glm::dvec3& p) {
        const double left = std::tan(view.field.left);
        const double up = std::tan(view.field.up);
        return {(p.x / -p.z - left) / (std::tan(view.field.right) - left) * view.sizePx.x,
                (up - p.y / -p.z) / (up - std::tan(view.field.down)) * view.sizePx.y};
    }
    static std::size_t indexOf(const SubmittedView& view, const glm::ivec2& pixel) {
        EXPECT_TRUE(pixel.x >= 0 && pixel.y >= 0 && pixel.x < view.sizePx.x && pixel.y < view.sizePx.y);
        return std::size_t(pixel.y) * std::size_t(view.sizePx.x) + std::size_t(pixel.x);
    }
    static glm::dvec2 centreOfLight(const SubmittedView& view) {
        glm::dvec2 sum(0.0);
        double weight = 0.0;
        for (int y = 0; y < view.sizePx.y; ++y) {
            for (int x = 0; x < view.sizePx.x; ++x) {
                const double light = view.rgba[indexOf(view, {x, y})].y;
                sum += light * glm::dvec2(x + 0.5, y + 0.5);
                weight += light;
            }
        }
        EXPECT_GT(weight, 0.0);
        return sum / weight;
    }
    static double linear(int encoded) {
        const double c = encoded / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
};

TEST_F(LayersTest, PosesAreThoseOfTheLastMoment) {
    Script script;
    script.foreseenAsideM = [](int asked) { return asked == 0 ? 0.05 : 0.0; };
    connect(script);
    show();
    frames(3);
    for (const SubmittedFrame& frame : xr_script::record().frames) {
        ASSERT_EQ(frame.views.size(), 2u);
        EXPECT_NEAR(frame.views[0].pose.positionM.x, -0.032, 1e-6) << frame.number;
        EXPECT_NEAR(frame.views[1].pose.positionM.x, 0.032, 1e-6) << frame.number;
    }
}

TEST_F(LayersTest, DepthsAreToldOnceTheyAreKnown) {
    for (const bool takesLayers : {true, false}) {
        SCOPED_TRACE(takesLayers);
        Script script;
        script.offersDepth = true;
        script.takesLayers = takesLayers;
        script.eyePx = {72, 60};
        for (xr_script::Field& field : script.fields) field = {-0.3f, 0.35f, 0.25f, -0.3f};
        connect(script);
        EXPECT_TRUE(runtime_->offer().takesDepth);
        show({.model = quickModel(), .learns = true});
        openAround(8.0, 0.5);
        EXPECT_EQ(xr_script::record().swapchains, takesLayers ? 2 : 4);
        frames(1);
        ASSERT_EQ(lastFrame().views.size(), 2u);
        EXPECT_FALSE(lastFrame().views[0].depth) << "nothing is learnt yet";
        findModel();
        frames(1);
        const SubmittedFrame shown = lastFrame();
        ASSERT_EQ(shown.views.size(), 2u);
        for (const SubmittedView& view : shown.views) {
            ASSERT_TRUE(view.depth);
            EXPECT_EQ(view.depth->sizePx, view.sizePx);
            EXPECT_EQ(view.depth->minDepth, 0.0f);
            EXPECT_EQ(view.depth->maxDepth, 1.0f);
            EXPECT_EQ(view.depth->nearM, 0.01f) << "the head may go inside";
            EXPECT_EQ(view.depth->farM, 100.0f);
            const glm::dvec3 marker = markerFrom(view);
            const double depth =
                view.depth->depths[indexOf(view, glm::ivec2(glm::floor(placeIn(view, marker))))];
            const double nearM = view.depth->nearM;
            const double farM = view.depth->farM;
            const double metres = nearM * farM / (farM - depth * (farM - nearM));
            // Somewhere in the ball, whose radius is 32 mm in the room.
            EXPECT_NEAR(metres, -marker.z, 0.045);
            EXPECT_EQ(view.depth->depths[indexOf(view, {0, view.sizePx.y - 1})], 1.0f) << "nothing is there";
        }
        headset_.reset();
        view_.reset();
        EXPECT_EQ(opened_->instance.validationMessageCount(), 0u);
        opened_.reset();
        runtime_.reset();
    }
}

TEST_F(LayersTest, WhatLensesHideIsNotDrawn) {
    const double side = std::tan(0.6);
    Script script;
    script.offersMask = true;
    script.offersDepth = true;
    script.hidden = {{-side, side}, {0.0, side}, {-side, 0.0}};  // the upper left corner
    script.blendModes = {1, 3};
    connect(script);
    EXPECT_TRUE(runtime_->offer().hasMask);
    show();
    frames(2);
    for (const SubmittedView& view : lastFrame().views) {
        EXPECT_EQ(view.sizePx, glm::ivec2(64)) << "a corner moves no side";
        EXPECT_EQ(view.rgba[indexOf(view, {0, 0})], glm::u8vec4(0));
        EXPECT_EQ(view.rgba[indexOf(view, {8, 4})], glm::u8vec4(0));
        EXPECT_EQ(view.rgba[indexOf(view, {40, 40})].w, 255);
        EXPECT_EQ(view.rgba[indexOf(view, {63, 0})].w, 255);
        EXPECT_EQ(view.rgba[indexOf(view, {0, 63})].w, 255);
    }
    // A strip at the right from now on: the picture ends where it begins.
    xr_script::changeMask({{0.4, 2}, {2, 2}, {2, -2}, {0.4, 2}, {2, -2}, {0.4, -2}});
    frames(2);
    for (const SubmittedView& view : lastFrame().views) {
        EXPECT_GE(std::tan(view.field.right), 0.4 - 1e-6);
        EXPECT_LE(std::tan(view.field.right), 0.45);
        EXPECT_NEAR(view.field.left, -0.6, 1e-6);
        EXPECT_LT(view.sizePx.x, 64);
        EXPECT_EQ(view.sizePx.y, 64);
        EXPECT_EQ(view.rgba[indexOf(view, {0, 0})].w, 255);
    }
    xr_script::changeMask({});
    frames(2);
    EXPECT_EQ(lastFrame().views[0].sizePx, glm::ivec2(64));
    // What is no mask is none.
    xr_script::changeMask({{std::nan(""), 2}, {2, 2}, {2, -2}});
    frames(2);
    EXPECT_EQ(lastFrame().views[0].sizePx, glm::ivec2(64));
}

TEST_F(LayersTest, InsetsShowTheSameFinerAndTheFoveaLiesInThem) {
    Script script;
    script.offersInsets = true;
    script.offersGaze = false;
    script.eyePx = {160, 160};
    script.insetPx = {128, 128};
    for (xr_script::Field& field : script.fields) field = {-0.3f, 0.3f, 0.3f, -0.3f};
    for (xr_script::Field& field : script.insetFields) field = {-0.16f, 0.2f, 0.16f, -0.16f};
    connect(script);
    EXPECT_TRUE(runtime_->offer().hasInsets);
    EXPECT_EQ(runtime_->offer().insetPx, glm::ivec2(128));
    show();
    openAround(4.0, 0.6);
    EXPECT_EQ(xr_script::record().swapchains, 2);
    frames(3);
    ASSERT_TRUE(headset_->shown()->insets);
    const double middle = 0.5 * (std::tan(0.2) - std::tan(0.16));
    EXPECT_NEAR(headset_->shown()->gaze.x, middle / std::tan(0.3), 0.03);
    EXPECT_NEAR(headset_->shown()->gaze.y, 0.0, 0.03);
    EXPECT_GT(headset_->shown()->fineness, 1.2);
    traceAll(headset_->shown()->eyes, 8);
    frames(1);
    const SubmittedFrame shown = lastFrame();
    ASSERT_EQ(shown.views.size(), 4u) << "eyes, then insets";
    for (std::size_t i = 0; i < 4; ++i) {
        const SubmittedView& view = shown.views[i];
        EXPECT_LE(view.sizePx.x, i < 2 ? 160 : 128);
        EXPECT_NEAR(view.pose.positionM.x, i % 2 == 0 ? -0.032 : 0.032, 1e-6);
        const glm::dvec2 found = centreOfLight(view);
        const glm::dvec2 expected = placeIn(view, markerFrom(view));
        // The middle of the light of a ball of some pixels, from 8 samples.
        EXPECT_NEAR(found.x, expected.x, 0.8) << i;
        EXPECT_NEAR(found.y, expected.y, 0.8) << i;
    }
    // Finer: the same angle has more pixels.
    const auto pixelOf = [](const SubmittedView& view) {
        return (std::tan(view.field.right) - std::tan(view.field.left)) / view.sizePx.x;
    };
    EXPECT_LT(pixelOf(shown.views[2]), 0.8 * pixelOf(shown.views[0]));
}

// A headset that has put its insets far aside: a whole picture around them would be far larger than they are.
TEST_F(LayersTest, InsetsFarAsideAreCoarserAndNotLarger) {
    Script script;
    script.offersInsets = true;
    script.offersDepth = true;
    script.offersGaze = false;
    script.insetPx = {64, 64};
    for (xr_script::Field& field : script.insetFields) field = {0.35f, 0.5f, 0.3f, 0.15f};
    connect(script);
    show();
    frames(2);
    ASSERT_EQ(lastFrame().views.size(), 4u);
    ASSERT_TRUE(headset_->shown()->insets);
    EXPECT_LE(headset_->shown()->insets->sizePx.x, 2 * 64 + 2);
    EXPECT_GE(lastFrame().views[2].sizePx.x, 8);
    EXPECT_GT(headset_->shown()->gaze.x, 0.4) << "the fovea lies there";
}

TEST_F(LayersTest, TheRoomIsSeenBehindWhereItIsWantedAndOffered) {
    struct Case {
        std::vector<int> offered;
        bool isWanted;
        int blendMode;
        bool usesAlpha;
    };
    // 1: opaque, 2: additive, 3: alpha blend.
    for (const Case& c :
         {Case{{1, 3}, true, 3, true}, Case{{1, 3}, false, 1, false}, Case{{3, 1}, false, 1, false},
          Case{{2}, false, 2, false}, Case{{2, 3}, true, 3, true}, Case{{1, 2}, true, 2, false},
          Case{{1}, true, 1, false}, Case{{3}, false, 3, true}}) {
        SCOPED_TRACE(c.blendMode * 10 + int(c.isWanted));
        Script script;
        script.blendModes = c.offered;
        for (xr_script::Field& field : script.fields) field = {-0.16f, 0.16f, 0.16f, -0.16f};
        connect(script);
        options_.session.showsRoom = c.isWanted;
        show();
        openAround(1.0, 0.6);
        frames(3);
        traceAll(headset_->shown()->eyes, 2);
        frames(1);
        const SubmittedFrame shown = lastFrame();
        EXPECT_EQ(shown.blendMode, c.blendMode);
        EXPECT_EQ(shown.usesAlpha, c.usesAlpha);
        ASSERT_EQ(shown.views.size(), 2u);
        for (const SubmittedView& view : shown.views) {
            const glm::u8vec4 corner = view.rgba[indexOf(view, {0, view.sizePx.y - 1})];
            const glm::u8vec4 marker =
                view.rgba[indexOf(view, glm::ivec2(glm::floor(placeIn(view, markerFrom(view)))))];
            EXPECT_EQ(corner.w, c.usesAlpha ? 0 : 255);
            EXPECT_EQ(corner.y, 0);
            EXPECT_GT(marker.w, 220);  // it covers 93 % of its pixel
            EXPECT_GT(marker.y, 100);
            for (const glm::u8vec4& pixel : view.rgba)
                EXPECT_LE(linear(pixel.y), pixel.w / 255.0 + 0.01) << "it is premultiplied";
        }
        headset_.reset();
        view_.reset();
        EXPECT_EQ(opened_->instance.validationMessageCount(), 0u);
        EXPECT_EQ(xr_script::record().violations, std::vector<std::string>{});
        opened_.reset();
        runtime_.reset();
    }
}

TEST_F(LayersTest, AFrameThatIsNotSeenCostsNothing) {
    const auto isSeen = std::make_shared<bool>(true);
    Script script;
    script.shouldRender = [isSeen](std::uint64_t) { return *isSeen; };
    connect(script);
    show({.model = quickModel(), .learns = true});
    frames(4);
    *isSeen = false;
    frames(1);
    const gpu::Ticket before = opened_->device->submittedTicket();
    frames(20);
    EXPECT_EQ(opened_->device->submittedTicket(), before) << "nothing was drawn, traced or learnt";
    EXPECT_TRUE(lastFrame().views.empty());
    EXPECT_TRUE(headset_->times().isEmpty);
    *isSeen = true;
    frames(1);
    EXPECT_EQ(lastFrame().views.size(), 2u);
}

// More frames than the device can draw: pictures become smaller, and each is there; then they grow again.
TEST_F(LayersTest, ASlowDeviceShowsLessAndEachFrame) {
    Script script;
    script.framesPerS = 1000.0;  // and it takes more than that to copy and read a picture
    script.keepsPictures = true;
    options_.holdsRate = true;
    connect(script);
    show();
    frames(40);
    const xr_script::Record hurried = xr_script::record();
    EXPECT_EQ(hurried.begun, hurried.ended);
    EXPECT_EQ(headset_->session().unsubmitted(), 0u);
    EXPECT_GT(headset_->governor().level(), 3u);
    EXPECT_EQ(lastFrame().views.size(), 2u);
    EXPECT_LT(lastFrame().views[0].sizePx.x, 64);
    EXPECT_NEAR(lastFrame().views[0].field.left, -0.6, 0.05) << "of the same field";
    const std::size_t level = headset_->governor().level();

    script.framesPerS = 1.0;
    xr_script::follow(script);
    frames(Governor::kFramesWithRoom + 5);
    EXPECT_LT(headset_->governor().level(), level);
    EXPECT_GT(headset_->governor().stepsUp(), 0u);
}

}  // namespace
}  // namespace macula::xr
