// Hands, panel and comfort together with what a headset may take besides: late poses, depths, masks, insets,
// the room.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "xr/scripted_room.h"
#include "xr/wrist_panel.h"

namespace macula::xr {
namespace {

using xr_script::Script;
using xr_script::SubmittedFrame;
using xr_script::SubmittedView;

constexpr double kRate = 30.0;

class RoomLayersTest : public ScriptedRoom {
  protected:
    // With the marker so far straight ahead of who stands there, at real size.
    void openAround(double aheadM) {
        glm::dmat4 placed = stageFromWorldBefore({{0.0, 1.6, 0.0}, {1, 0, 0, 0}}, view_->seenMm());
        placed[3] = glm::dvec4(glm::dvec3(0.0, 1.6, -aheadM) - glm::dmat3(placed) * markerMm(), 1.0);
        open(placed);
    }
    static int mostAlpha(const SubmittedView& view) {
        int most = 0;
        for (const glm::u8vec4& pixel : view.rgba) most = std::max(most, int(pixel.w));
        return most;
    }
    // The left fist shows its panel, the right hand points at a button of it.
    static xr_script::Hand left() {
        xr_script::Hand hand;
        hand.pose = {{0.0, 1.35, -0.56}, glm::angleAxis(glm::radians(90.0), glm::dvec3(1, 0, 0))};
        return hand;
    }
    static Pose panel() {
        const xr_script::Pose fist = left().pose;
        return WristPanel::poseAt({fist.positionM, fist.orientation});
    }
    static xr_script::Hand right() {
        const glm::dvec3 from(0.1, 1.4, -0.2);
        const glm::dvec3 to =
            WristPanel::poseOf(panel(), WristPanel::middleOf(PanelButton::quality)).positionM;
        xr_script::Hand hand;
        hand.pose.positionM = from;
        hand.aim = xr_script::Pose{from, glm::quatLookAt(glm::normalize(to - from), glm::dvec3(0, 1, 0))};
        return hand;
    }
};

TEST_F(RoomLayersTest, ThePanelFloatsBeforeAllThatAHeadsetTakes) {
    const double side = std::tan(0.6);
    Script script;
    script.framesPerS = kRate;
    script.offersDepth = script.offersMask = script.offersInsets = script.offersHands = true;
    script.hidden = {{-side, side}, {0.0, side}, {-side, 0.0}};  // the upper left corner
    script.blendModes = {1, 3};
    script.foreseenAsideM = [](int asked) { return asked == 0 ? 0.03 : 0.0; };
    script.hand = [](double, int hand) { return std::optional(hand == 0 ? left() : right()); };
    connect(script);
    options_.session.showsRoom = true;
    show({.model = quickModel(), .learns = true});
    openAround(0.5);
    frames(4);
    for (int i = 0; i < 2000 && !view_->model().canBeDrawn(); ++i)
        expectOk(view_->model().work(20.0, [] { return true; }));
    ASSERT_TRUE(view_->model().canBeDrawn());
    frames(2);
    const SubmittedFrame shown = lastFrame();
    EXPECT_EQ(shown.blendMode, 3);
    EXPECT_TRUE(shown.usesAlpha);
    ASSERT_EQ(shown.views.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const SubmittedView& view = shown.views[i];
        EXPECT_NEAR(view.pose.positionM.x, i % 2 == 0 ? -0.032 : 0.032, 1e-6)
            << "the pose of the last moment";
        ASSERT_TRUE(view.depth) << i;
        EXPECT_EQ(view.depth->sizePx, view.sizePx);
        if (i < 2) {
            EXPECT_EQ(view.rgba[0], glm::u8vec4(0)) << "no lens shows it";
        }
    }
    ASSERT_EQ(shown.quads.size(), 2u) << "the panel, and before it where the hand points";
    EXPECT_NEAR(glm::distance(shown.quads[0].pose.positionM, panel().positionM), 0.0, 1e-5);
    EXPECT_EQ(shown.quads[0].sizePx, WristPanel::kSizePx);
    EXPECT_EQ(headset_->controls().pointedAt(), PanelButton::quality);
    EXPECT_LT(glm::distance(shown.quads[1].pose.positionM, panel().positionM), 0.2);
}

// Black would hide the room from who does not know where they are.
TEST_F(RoomLayersTest, WhoIsLostSeesTheRoom) {
    const auto isTracked = std::make_shared<bool>(true);
    Script script;
    script.framesPerS = kRate;
    script.offersMask = true;
    script.blendModes = {1, 3};
    script.isTracked = [isTracked](double) { return *isTracked; };
    for (xr_script::Field& field : script.fields) field = {-0.16f, 0.16f, 0.16f, -0.16f};
    for (const bool showsRoom : {true, false}) {
        SCOPED_TRACE(showsRoom);
        *isTracked = true;
        connect(script);
        options_.session.showsRoom = showsRoom;
        show();
        openAround(0.6);
        frames(3);
        traceAll(headset_->shown()->eyes, 2);
        frames(1);
        for (const SubmittedView& view : lastFrame().views) EXPECT_GT(mostAlpha(view), 220);
        *isTracked = false;
        frames(std::uint64_t(std::ceil(Fade::kSeconds * kRate)) + 2);
        const SubmittedFrame dark = lastFrame();
        ASSERT_EQ(dark.views.size(), 2u);
        for (const SubmittedView& view : dark.views) {
            EXPECT_EQ(mostAlpha(view), showsRoom ? 0 : 255);
            for (const glm::u8vec4& pixel : view.rgba) ASSERT_EQ(glm::ivec3(pixel), glm::ivec3(0));
        }
        EXPECT_EQ(dark.quads.size(), 1u) << "it is said";
        *isTracked = true;
        frames(std::uint64_t(std::ceil(Fade::kSeconds * kRate)) + 2);
        for (const SubmittedView& view : lastFrame().views) EXPECT_GT(mostAlpha(view), 220);
        headset_.reset();
        view_.reset();
        EXPECT_EQ(opened_->instance.validationMessageCount(), 0u);
        EXPECT_EQ(xr_script::record().violations, std::vector<std::string>{});
        opened_.reset();
        runtime_.reset();
    }
}

// What a person chose, as far as there is time for it.
TEST_F(RoomLayersTest, QualityIsAShareOfWhatTheGovernorAllows) {
    struct Case {
        RoomQuality quality;
        std::uint32_t allowed;
        std::uint32_t samples;
    };
    Script script;
    script.eyePx = {32, 32};
    connect(script);
    show();
    frames(2);
    const EyePictures eyes = headset_->shown()->eyes;
    for (const Case& c :
         {Case{RoomQuality::balanced, 4, 4}, Case{RoomQuality::fine, 4, 16}, Case{RoomQuality::fine, 1, 4},
          Case{RoomQuality::fast, 8, 2}, Case{RoomQuality::fast, 1, 1}}) {
        SCOPED_TRACE(RoomWords().of(c.quality) + " " + std::to_string(c.allowed));
        RoomState state = view_->state();
        state.quality = c.quality;
        ASSERT_TRUE(expectOk(view_->show(state)));
        for (int i = 0; i < 20 && view_->frame().isTracing(); ++i)
            static_cast<void>(expectOk(view_->frame().traceFovea([] { return true; })));
        view_->frame().forgetFovea();
        for (int i = 0; i < 20; ++i)
            expectOk(view_->work(Work::fovea, eyes, {.budgetMs = 2000.0, .mostSamples = c.allowed}));
        EXPECT_EQ(expectOk(view_->draw(eyes)).frame.foveaSamples, c.samples);
    }
}

// Where there is no time for anything, what a hand shows for a look is seen nevertheless.
TEST_F(RoomLayersTest, ALookIsNotDarkOnASlowDevice) {
    Script script;
    script.framesPerS = 1000.0;  // and it takes more than that to copy and read a picture
    options_.holdsRate = true;
    connect(script);
    show();
    frames(40);
    ASSERT_GT(headset_->governor().level(), 3u);
    for (int i = 0; i < 4; ++i) {
        Clip clip;
        clip.planes.push_back({.normal = {1, 0, 0}, .offsetMm = markerMm().x - 0.25 * i});
        RoomState state = view_->state();
        state.clip = std::make_shared<const Clip>(clip);
        ASSERT_TRUE(expectOk(view_->show(state, Lasts::forALook)));
        EXPECT_TRUE(view_->isDark());
        frames(15);
        EXPECT_FALSE(view_->isDark()) << i;
        EXPECT_EQ(view_->scene().drawing.clip, nullptr);
    }
}

}  // namespace
}  // namespace macula::xr
