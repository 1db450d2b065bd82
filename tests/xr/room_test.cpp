// Hands, panel and comfort in the scripted headset: what reaches the software of the headset, and what it is
// shown.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <thread>

#include "image/image_file.h"
#include "xr/hands.h"
#include "xr/scripted_room.h"
#include "xr/wrist_panel.h"

namespace macula::xr {
namespace {

using xr_script::Script;

constexpr double kRate = 30.0;

class RoomTest : public ScriptedRoom {
  protected:
    using Hands = std::array<std::optional<xr_script::Hand>, 2>;

    // Hands do what `hands_` says.
    Script withHands() const {
        Script script;
        script.framesPerS = kRate;
        script.hand = [hands = hands_](double, int hand) { return (*hands)[std::size_t(hand)]; };
        return script;
    }
    // With presets, and what hands choose.
    void showWith(RoomHost host = {}) {
        view_.emplace(expectOk(RoomView::create(opened_->device, scene(),
                                                std::make_shared<hybrid::ModelShelf>(std::uint64_t(1) << 20),
                                                {.model = {}, .learns = false})));
        auto other = std::make_shared<TransferFunction>(*scene().drawing.transferFunction);
        other->name = "other";
        other->title = "Other";
        host.presets = {other};
        open({}, std::make_shared<RoomControls>(std::move(host), view_->state()));
    }
    static xr_script::Hand held(const glm::dvec3& positionM, float squeeze = 0.0f, float trigger = 0.0f) {
        xr_script::Hand hand;
        hand.pose.positionM = positionM;
        hand.squeeze = squeeze;
        hand.trigger = trigger;
        return hand;
    }
    // The left fist shows its panel, the right hand points at a button of it.
    void point(PanelButton button, float trigger) {
        const Pose fist{{0.0, 1.35, -0.56}, glm::angleAxis(glm::radians(90.0), glm::dvec3(1, 0, 0))};
        const glm::dvec3 from(0.1, 1.4, -0.2);
        const glm::dvec3 to =
            WristPanel::poseOf(WristPanel::poseAt(fist), WristPanel::middleOf(button)).positionM;
        xr_script::Hand left;
        left.pose = {fist.positionM, fist.orientation};
        xr_script::Hand right = held(from, 0.0f, trigger);
        right.aim = xr_script::Pose{from, glm::quatLookAt(glm::normalize(to - from), glm::dvec3(0, 1, 0))};
        (*hands_)[0] = left;
        (*hands_)[1] = right;
    }
    void press(PanelButton button) {
        point(button, 0.0f);
        frames(3);
        point(button, 1.0f);
        frames(2);
        point(button, 0.0f);
        frames(2);
    }
    static double brightness(const xr_script::SubmittedFrame& frame) {
        double sum = 0.0;
        for (const xr_script::SubmittedView& view : frame.views)
            for (const glm::u8vec4& pixel : view.rgba) sum += pixel.y;
        return sum;
    }
    // All samples that a head at rest is given. The headset takes its own steps toward them, as far as the
    // machine's speed lets it.
    void traceToTheEnd() {
        const Headset::Shown& shown = *headset_->shown();
        for (int doubled = 0; doubled < 12; ++doubled)
            expectOk(view_->work(
                Work::fovea, shown.eyes,
                {.budgetMs = 1e6, .gaze = shown.gaze, .fineness = shown.fineness, .mostSamples = 64}));
    }

    std::shared_ptr<Hands> hands_ = std::make_shared<Hands>();
};

TEST_F(RoomTest, EachProfileOfTheListIsTaken) {
    Script script = withHands();
    script.offersReverb = true;
    connect(script);
    show();
    frames(1);
    const std::vector<std::string> taken = xr_script::record().profiles;
    EXPECT_GE(interactionProfiles().size(), 6u);
    for (const InteractionProfile& profile : interactionProfiles())
        EXPECT_EQ(std::count(taken.begin(), taken.end(), profile.name), 1) << profile.name;
}

// Of each kind of controller: it grabs, cuts, turns and is felt.
TEST_F(RoomTest, EachKindOfControllerDoesItAll) {
    for (const InteractionProfile& profile : interactionProfiles()) {
        SCOPED_TRACE(profile.name);
        *hands_ = {};
        Script script = withHands();
        script.offersReverb = true;
        script.controllers = profile.name;
        headset_.reset();
        view_.reset();
        opened_.reset();
        runtime_.reset();
        connect(script);
        show();
        frames(3);
        const glm::dmat4 placed = *headset_->placed();
        (*hands_)[1] = held({0.2, 1.6, -0.4}, 1.0f);
        frames(2);
        (*hands_)[1] = held({0.3, 1.6, -0.4}, 1.0f);
        frames(1);
        EXPECT_NEAR(glm::distance(glm::dvec3((*headset_->placed())[3]) - glm::dvec3(placed[3]),
                                  glm::dvec3(0.1, 0.0, 0.0)),
                    0.0, 1e-6);
        ASSERT_EQ(xr_script::record().pulses.size(), 1u) << "felt once, as it is taken";
        EXPECT_EQ(xr_script::record().pulses[0].hand, 1);
        EXPECT_GT(xr_script::record().pulses[0].strength, 0.0f);
        EXPECT_GT(xr_script::record().pulses[0].ms, 0.0);

        const double markerX = transformPoint(*headset_->placed(), markerMm()).x;
        (*hands_)[1] = held({markerX, 1.6, -0.4}, 0.0f, 1.0f);
        frames(2);
        EXPECT_EQ(xr_script::record().pulses.size(), 2u) << "and as the cut is begun";
        (*hands_)[1] = held({markerX, 1.6, -0.4}, 0.0f, 0.0f);
        frames(2);
        ASSERT_NE(view_->scene().drawing.clip, nullptr);
        EXPECT_EQ(view_->scene().drawing.clip->planes.size(), 1u);

        const glm::dmat4 before = *headset_->placed();
        (*hands_)[0] = held({-0.2, 1.6, -0.4});
        (*hands_)[0]->stick = 1.0f;
        frames(2);
        if (profile.turnsWhile) {
            EXPECT_EQ(*headset_->placed(), before) << "a pad is touched all the time";
            (*hands_)[0]->isPadPressed = true;
            frames(2);
        }
        const glm::dmat4 change = *headset_->placed() * glm::inverse(before);
        const double turnedDeg = glm::degrees(std::atan2(change[2][0], change[2][2]));
        EXPECT_NEAR(turnedDeg, profile.turn ? 30.0 : 0.0, 1e-3);
    }
}

TEST_F(RoomTest, ARayPressesThePanelWhichIsSeenAndFelt) {
    connect(withHands());
    showWith();
    frames(3);
    EXPECT_TRUE(lastFrame().quads.empty()) << "nobody looks at a wrist";
    point(PanelButton::presetNext, 0.0f);
    frames(3);
    ASSERT_EQ(lastFrame().quads.size(), 2u) << "panel, and the point that is meant";
    const xr_script::SubmittedQuad panel = lastFrame().quads[0];
    EXPECT_EQ(panel.sizePx, WristPanel::kSizePx);
    EXPECT_NEAR(panel.sizeM.x, 0.20, 1e-6);
    EXPECT_NEAR(glm::distance(panel.pose.positionM, glm::dvec3(0.0, 1.5, -0.5)), 0.0, 1e-5);
    // What was drawn is what the headset got.
    const PanelPicture& drawn = headset_->controls().picture(RoomPicture::panel);
    EXPECT_TRUE(std::equal(panel.rgba.begin(), panel.rgba.end(), drawn.pixels().begin()));

    press(PanelButton::presetNext);
    EXPECT_EQ(view_->scene().drawing.transferFunction->name, "other");
    EXPECT_EQ(xr_script::record().pulses.size(), 1u);
    EXPECT_EQ(view_->scene().drawing.clip, nullptr) << "nothing was cut by that";
    const PanelPicture& other = headset_->controls().picture(RoomPicture::panel);
    const auto got = lastFrame().quads[0].rgba;
    EXPECT_TRUE(std::equal(got.begin(), got.end(), other.pixels().begin())) << "the new name";
    press(PanelButton::undo);
    EXPECT_NE(view_->scene().drawing.transferFunction->name, "other");
    *hands_ = {};
    frames(2);
    EXPECT_TRUE(lastFrame().quads.empty());
}

TEST_F(RoomTest, AKnifeThatRestsShowsItsCutForALook) {
    connect(withHands());
    showWith();
    frames(3);
    const double markerX = transformPoint(*headset_->placed(), markerMm()).x;
    const Box before = view_->seenMm();
    (*hands_)[1] = held({markerX, 1.6, -0.4}, 0.0f, 1.0f);
    frames(12);
    EXPECT_EQ(view_->scene().drawing.clip, nullptr) << "it is not chosen yet";
    EXPECT_EQ(lastFrame().quads.size(), 2u) << "the blade";
    // By blocks of 8 voxels: those wholly to the right of the knife are gone.
    EXPECT_LT(view_->seenMm().high.x, before.high.x - 2.0);
    (*hands_)[1].reset();
    frames(2);
    EXPECT_EQ(view_->seenMm().high.x, before.high.x) << "the hand was lost: all is back";
    EXPECT_EQ(view_->scene().drawing.clip, nullptr);
}

TEST_F(RoomTest, RecentringPutsItBeforeWhoeverLooks) {
    Script script = withHands();
    const auto head = std::make_shared<xr_script::Pose>();
    head->positionM = {0.0, 1.6, 0.0};
    script.head = [head](double) { return *head; };
    connect(script);
    show();
    frames(3);
    const glm::dmat4 placed = *headset_->placed();
    head->positionM = {0.5, 1.2, 0.3};
    head->orientation = glm::angleAxis(glm::radians(-90.0), glm::dvec3(0, 1, 0));
    frames(3);
    EXPECT_EQ(*headset_->placed(), placed) << "it stays where it is while somebody walks";
    xr_script::recentre();
    frames(2);
    const glm::dmat4 wanted = stageFromWorldBefore({head->positionM, head->orientation}, view_->seenMm());
    for (int column = 0; column < 4; ++column)
        EXPECT_NEAR(glm::distance((*headset_->placed())[column], wanted[column]), 0.0, 1e-5);
    EXPECT_NEAR(scaleOf(*headset_->placed()), 1.0, 1e-9);
}

TEST_F(RoomTest, ASpaceThatWillBeAnotherOneIsFollowedWhenItIs) {
    connect(withHands());
    show();
    frames(3);
    (*hands_)[1] = held({0.2, 1.6, -0.4}, 1.0f);
    frames(2);
    (*hands_)[1] = held({0.6, 1.6, -0.4}, 1.0f);
    frames(2);
    (*hands_)[1].reset();
    frames(2);
    const glm::dmat4 moved = *headset_->placed();
    xr_script::recentre(4.5 / kRate);
    frames(4);
    EXPECT_EQ(*headset_->placed(), moved) << "its poses are those of before";
    frames(1);
    const glm::dmat4 wanted = stageFromWorldBefore({{0.0, 1.6, 0.0}, {1, 0, 0, 0}}, view_->seenMm());
    for (int column = 0; column < 4; ++column)
        EXPECT_NEAR(glm::distance((*headset_->placed())[column], wanted[column]), 0.0, 1e-5);
}

TEST_F(RoomTest, WhatIsLetGoWhileTheHeadsetShowsNothingIsNotCut) {
    Script script = withHands();
    const auto isShown = std::make_shared<bool>(true);
    script.shouldRender = [isShown](std::uint64_t) { return *isShown; };
    connect(script);
    show();
    frames(3);
    const double markerX = transformPoint(*headset_->placed(), markerMm()).x;
    (*hands_)[1] = held({markerX, 1.6, -0.4}, 0.0f, 1.0f);
    frames(2);
    *isShown = false;
    frames(2);
    (*hands_)[1] = held({markerX, 1.6, -0.4}, 0.0f, 0.0f);
    *isShown = true;
    frames(2);
    EXPECT_EQ(view_->scene().drawing.clip, nullptr);
    // Nor in the session after one that was lost meanwhile.
    (*hands_)[1] = held({markerX, 1.6, -0.4}, 0.0f, 1.0f);
    frames(2);
    auto kept = std::make_shared<RoomControls>(headset_->controls());
    (*hands_)[1] = held({markerX, 1.6, -0.4}, 0.0f, 0.0f);
    open(headset_->placed(), std::move(kept));
    frames(4);
    EXPECT_EQ(view_->scene().drawing.clip, nullptr);
}

TEST_F(RoomTest, WhatIsHeldWhileSomebodyRecentresDoesNotJumpBack) {
    connect(withHands());
    show();
    frames(3);
    (*hands_)[1] = held({0.2, 1.6, -0.4}, 1.0f);
    frames(2);
    (*hands_)[1] = held({0.6, 1.6, -0.4}, 1.0f);
    frames(2);
    xr_script::recentre();
    frames(3);
    const glm::dmat4 wanted = stageFromWorldBefore({{0.0, 1.6, 0.0}, {1, 0, 0, 0}}, view_->seenMm());
    for (int column = 0; column < 4; ++column)
        EXPECT_NEAR(glm::distance((*headset_->placed())[column], wanted[column]), 0.0, 1e-5);
}

TEST_F(RoomTest, ASessionThatIsLostWhileAHandFeelsIsTold) {
    Script script = withHands();
    script.loseAt = "xrApplyHapticFeedback";
    script.answer = -17;  // XR_ERROR_SESSION_LOST
    connect(script);
    show();
    frames(3);
    (*hands_)[1] = held({0.2, 1.6, -0.4}, 1.0f);
    std::optional<Error> error;
    for (int i = 0; i < 10 && !error; ++i) {
        const auto step = headset_->step();
        if (!step) error = step.error();
    }
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::deviceLost);
}

TEST_F(RoomTest, LostTrackingFadesThePictureAndComesBack) {
    Script script = withHands();
    const auto tracked = std::make_shared<bool>(true);
    script.isTracked = [tracked](double) { return *tracked; };
    connect(script);
    show();
    frames(3);
    traceToTheEnd();  // from here on, only the light changes
    frames(1);
    const double usual = brightness(lastFrame());
    ASSERT_GT(usual, 0.0);
    frames(2);
    ASSERT_EQ(brightness(lastFrame()), usual);
    *tracked = false;
    frames(5);  // half of the time
    EXPECT_LT(brightness(lastFrame()), usual);
    EXPECT_GT(brightness(lastFrame()), 0.0);
    frames(10);
    EXPECT_EQ(brightness(lastFrame()), 0.0);
    EXPECT_EQ(lastFrame().views.size(), 2u) << "frames go on";
    ASSERT_EQ(lastFrame().quads.size(), 1u) << "and a sentence";
    *tracked = true;
    frames(15);
    EXPECT_EQ(brightness(lastFrame()), usual);
}

TEST_F(RoomTest, BareHandsGrabAndCutByPinching) {
    Script script;
    script.framesPerS = kRate;
    script.offersHands = true;
    const auto bare = std::make_shared<xr_script::BareHand>();
    bare->palm.positionM = {0.2, 1.6, -0.4};
    script.bareHand = [bare](double, int hand) { return hand == 1 ? std::optional(*bare) : std::nullopt; };
    connect(script);
    show();
    frames(3);
    const glm::dmat4 placed = *headset_->placed();
    EXPECT_EQ(xr_script::record().handTrackers, 2);
    bare->palm.positionM.x = 0.25;
    frames(2);
    EXPECT_EQ(*headset_->placed(), placed) << "fingers are apart";
    bare->indexApartM = 0.015;
    frames(2);
    bare->palm.positionM.x = 0.35;
    frames(1);
    EXPECT_NEAR((*headset_->placed())[3].x - placed[3].x, 0.1, 1e-6);
    bare->indexApartM = 0.1;
    frames(2);
    const double markerX = transformPoint(*headset_->placed(), markerMm()).x;
    bare->palm.positionM.x = markerX;
    bare->middleApartM = 0.015;
    frames(2);
    bare->middleApartM = 0.1;
    frames(2);
    ASSERT_NE(view_->scene().drawing.clip, nullptr);
    EXPECT_NEAR(view_->scene().drawing.clip->planes[0].offsetMm, -markerMm().x, 1e-3);
}

TEST_F(RoomTest, WhatWasChosenOutlivesASession) {
    connect(withHands());
    showWith();
    frames(3);
    press(PanelButton::presetNext);
    press(PanelButton::quality);
    RoomHost host;
    host.presets = headset_->controls().host().presets;
    const RoomState kept = headset_->controls().state();
    EXPECT_EQ(kept.quality, RoomQuality::fine);
    EXPECT_EQ(kept, view_->state());
    const auto placed = headset_->placed();
    open(placed, std::make_shared<RoomControls>(host, kept));
    frames(3);
    EXPECT_EQ(headset_->placed(), placed);
    EXPECT_EQ(headset_->controls().state(), kept);
}

TEST_F(RoomTest, MirrorAndPictureAreOfTheLeftEyeAndNameNobody) {
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "macula-room-pictures";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    connect(withHands());
    std::vector<EyeView> mirrored;
    std::vector<std::string> notes;
    RoomHost host;
    host.pictures = folder;
    host.mirror = [&](EyeView view) { mirrored.push_back(std::move(view)); };
    host.note = [&](const std::string& sentence) { notes.push_back(sentence); };
    showWith(std::move(host));
    frames(3);
    traceAll(headset_->shown()->eyes, 4);
    frames(12);
    // At most ten a second, of frames that were 30 a second.
    ASSERT_GE(mirrored.size(), 2u);
    EXPECT_LE(mirrored.size(), 6u);
    EXPECT_EQ(mirrored.back().sizePx, lastFrame().views[0].sizePx);
    ASSERT_EQ(mirrored.back().rgba.size(), lastFrame().views[0].rgba.size() * 4);
    int brightest = 0;
    for (std::size_t i = 0; i < mirrored.back().rgba.size(); i += 4)
        brightest = std::max(brightest, int(mirrored.back().rgba[i]));
    EXPECT_GT(brightest, 50);

    press(PanelButton::picture);
    const auto path = folder / "macula-headset-1.png";
    for (int i = 0; i < 300 && notes.empty(); ++i) {
        frames(1);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0], "Picture macula-headset-1.png is written.");
    const image::Image picture = expectOk(image::readImage(path));
    EXPECT_EQ(picture.width, lastFrame().views[0].sizePx.x);
    const std::vector<std::string> keys{"ImageDescription"};
    const image::Metadata said = expectOk(image::readMetadata(path, keys));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].second.find("not for primary diagnosis"), std::string::npos);
    // The next has the next name.
    EXPECT_EQ(expectOk(writeEyeView(mirrored.back(), folder)).filename(), "macula-headset-2.png");
    EXPECT_FALSE(writeEyeView(mirrored.back(), folder / "none").ok());
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace macula::xr
