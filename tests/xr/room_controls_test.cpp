// What a person does in the room, without a headset: the panel is pressed by a ray, tools cut, steps are
// undone.
#include "xr/room_controls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "gpu/gpu_test.h"
#include "xr/placement.h"

namespace macula::xr {
namespace {

using gpu::expectOk;

const Box kSeen{{-100, -100, -100}, {100, 100, 100}};
const Pose kHead{{0.0, 1.6, 0.0}, {1, 0, 0, 0}};
// A fist held upright: its panel is at (0, 1.5, -0.5), and looks to the head.
const Pose kFist{{0.0, 1.35, -0.56}, glm::angleAxis(glm::radians(90.0), glm::dvec3(1, 0, 0))};

std::shared_ptr<const TransferFunction> preset(const std::string& name) {
    TransferFunction made;
    made.name = name;
    made.title = name;
    made.opacity = {{.value = 100.0, .opacity = 0.0}, {.value = 600.0, .opacity = 1.0}};
    made.colour = {{.value = 100.0, .colour = glm::dvec3(1.0)}};
    return std::make_shared<const TransferFunction>(made);
}

class RoomControlsTest : public ::testing::Test {
  protected:
    void SetUp() override { begin({}); }
    void begin(RoomWords words,
               std::vector<std::shared_ptr<const TransferFunction>> presets = {preset("one"), preset("two"),
                                                                               preset("three")},
               bool isCalibrated = true) {
        RoomHost host;
        host.isCalibrated = isCalibrated;
        host.words = std::move(words);
        host.presets = std::move(presets);
        host.pictures = "somewhere";
        host.note = [this](const std::string& sentence) { notes_.push_back(sentence); };
        host.changed = [this](const RoomState&) { ++changes_; };
        host.wanted = [this] { return std::exchange(wanted_, std::nullopt); };
        RoomState first;
        first.transferFunction = host.presets.front();
        controls_.emplace(std::move(host), first);
        placed_ = stageFromWorldBefore(kHead, kSeen);
    }

    RoomFollowed frame(const TwoHands& hands, double passed = 1.0 / 90.0, bool isTracked = true) {
        seconds_ += passed;
        RoomFrame made;
        made.seconds = seconds_;
        made.head = kHead;
        made.hands = hands;
        made.isTracked = isTracked;
        made.seenMm = kSeen;
        RoomFollowed followed =
            expectOk(controls_->follow(placed_, made, [this](const RoomState& state, Lasts lasts) {
                shown_.push_back({state, lasts});
                return Result<bool>(!refuses_);
            }));
        placed_ = followed.stageFromWorld;
        return followed;
    }
    // The right hand points at a button of the panel at the left wrist.
    static TwoHands pointing(PanelButton button, float press) {
        const Pose panel = WristPanel::poseAt(kFist);
        const glm::dvec3 from(0.1, 1.4, -0.2);
        const glm::dvec3 to = WristPanel::poseOf(panel, WristPanel::middleOf(button)).positionM;
        TwoHands hands;
        hands[0].grip = kFist;
        hands[1].grip = Pose{from, {1, 0, 0, 0}};
        hands[1].aim = Pose{from, glm::quatLookAt(glm::normalize(to - from), glm::dvec3(0, 1, 0))};
        hands[1].press = hands[1].trigger = press;  // as of most controllers
        return hands;
    }
    // Comes, presses, lets go; what came of the press.
    RoomFollowed press(PanelButton button) {
        frame(pointing(button, 0.0f));
        frame(pointing(button, 0.0f));
        RoomFollowed pressed = frame(pointing(button, 1.0f));
        frame(pointing(button, 1.0f));
        frame(pointing(button, 0.0f));
        return pressed;
    }
    static TwoHands knife(double x, float trigger) {
        TwoHands hands;
        hands[1].grip = Pose{{x, 1.6, -0.5}, {1, 0, 0, 0}};
        hands[1].trigger = trigger;
        return hands;
    }
    void cutAt(double x) {
        frame(knife(x, 0.0f));
        frame(knife(x, 1.0f));
        frame(knife(x, 0.0f));
    }
    std::size_t planes() const {
        return controls_->state().clip ? controls_->state().clip->planes.size() : 0;
    }
    std::string presetName() const { return controls_->state().transferFunction->name; }

    struct Shown {
        RoomState state;
        Lasts lasts = Lasts::forGood;
    };
    std::optional<RoomControls> controls_;
    glm::dmat4 placed_{1.0};
    double seconds_ = 10.0;
    std::vector<Shown> shown_;
    std::vector<std::string> notes_;
    std::optional<RoomState> wanted_;
    int changes_ = 0;
    bool refuses_ = false;
};

TEST_F(RoomControlsTest, PresetsGoRoundAndCanBeUndone) {
    const RoomFollowed pressed = press(PanelButton::presetNext);
    EXPECT_EQ(presetName(), "two");
    ASSERT_EQ(pressed.pulses.size(), 1u) << "it is felt";
    EXPECT_EQ(pressed.pulses[0].hand, 1u);
    EXPECT_EQ(changes_, 1);
    press(PanelButton::presetNext);
    press(PanelButton::presetNext);
    EXPECT_EQ(presetName(), "one");
    press(PanelButton::presetBefore);
    EXPECT_EQ(presetName(), "three");
    for (const char* name : {"one", "three", "two", "one"}) {
        press(PanelButton::undo);
        EXPECT_EQ(presetName(), name);
    }
    const std::size_t shown = shown_.size();
    press(PanelButton::undo);
    EXPECT_EQ(shown_.size(), shown) << "there is nothing to undo";
}

TEST_F(RoomControlsTest, APressNeitherCutsNorIsMadeByASweep) {
    press(PanelButton::knife);
    EXPECT_EQ(controls_->toolOf(1), ClipTool::none);
    press(PanelButton::knife);
    EXPECT_EQ(controls_->toolOf(1), ClipTool::knife);
    EXPECT_EQ(planes(), 0u);
    // The trigger that was pulled on the panel is let go beside it.
    frame(pointing(PanelButton::quality, 0.0f));
    frame(pointing(PanelButton::quality, 1.0f));
    frame(knife(0.0, 1.0f));
    frame(knife(0.0, 0.0f));
    EXPECT_EQ(planes(), 0u);
    EXPECT_EQ(controls_->state().quality, RoomQuality::fine);
    // Pulled elsewhere, and swept over the panel: it is a cut that goes on, and no press.
    TwoHands away = knife(0.0, 1.0f);
    away[1].press = 1.0f;
    frame(away);
    frame(pointing(PanelButton::presetNext, 1.0f));
    frame(pointing(PanelButton::presetNext, 1.0f));
    EXPECT_EQ(presetName(), "one");
    frame(knife(0.0, 0.0f));
    EXPECT_EQ(planes(), 1u);
}

TEST_F(RoomControlsTest, AShiftMovesTheCurveAndSaysHowFar) {
    press(PanelButton::shiftHigher);
    press(PanelButton::shiftHigher);
    press(PanelButton::shiftLower);
    press(PanelButton::shiftHigher);
    const TransferFunction& now = *controls_->state().transferFunction;
    EXPECT_NEAR(now.opacity.front().value, 120.0, 1e-9) << "two steps of a fiftieth of 500";
    EXPECT_NEAR(now.opacity.back().value, 620.0, 1e-9);
    EXPECT_NE(now.name, "one") << "a copy of its own";
    EXPECT_EQ(controls_->texts().shift, "Shift +20 HU");
    press(PanelButton::presetNext);
    EXPECT_EQ(presetName(), "two") << "the one after that which it was copied from";
    EXPECT_EQ(controls_->texts().shift, "Shift +0 HU");
}

TEST_F(RoomControlsTest, AShiftIsSaidWithoutPowersOfTen) {
    TransferFunction wide = *preset("wide");
    wide.opacity = {{.value = 0.0, .opacity = 0.0}, {.value = 4000.0, .opacity = 1.0}};
    TransferFunction odd = *preset("odd");
    odd.opacity = {{.value = 0.3, .opacity = 0.0}, {.value = 812.9, .opacity = 1.0}};
    begin({},
          {std::make_shared<const TransferFunction>(wide), std::make_shared<const TransferFunction>(odd)});
    for (int i = 0; i < 13; ++i) press(PanelButton::shiftLower);
    EXPECT_EQ(controls_->texts().shift, "Shift -1040 HU");
    press(PanelButton::presetNext);
    for (int i = 0; i < 3; ++i) press(PanelButton::shiftHigher);
    for (int i = 0; i < 3; ++i) press(PanelButton::shiftLower);
    EXPECT_NE(controls_->state().transferFunction->opacity.front().value, 0.3) << "rounded";
    EXPECT_EQ(controls_->texts().shift, "Shift +0 HU") << "to and fro";
}

TEST_F(RoomControlsTest, KnifeAndResetAreSteps) {
    cutAt(0.02);
    ASSERT_EQ(planes(), 1u);
    EXPECT_NEAR(controls_->state().clip->planes[0].offsetMm, -20.0, 1e-9);
    EXPECT_NEAR(controls_->state().clip->planes[0].normal.x, -1.0, 1e-9);
    cutAt(-0.02);
    EXPECT_EQ(planes(), 2u);
    press(PanelButton::resetClips);
    EXPECT_EQ(controls_->state().clip, nullptr);
    press(PanelButton::undo);
    EXPECT_EQ(planes(), 2u);
    press(PanelButton::undo);
    EXPECT_EQ(planes(), 1u);
    for (int i = 0; i < 7; ++i) cutAt(0.03 + 0.01 * i);
    EXPECT_EQ(planes(), Clip::kMostPlanes);
    ASSERT_FALSE(notes_.empty());
    EXPECT_NE(notes_.back().find("six cuts"), std::string::npos);
}

TEST_F(RoomControlsTest, AHandThatRestsShowsTheCutForALook) {
    RoomFollowed begun = frame(knife(0.02, 1.0f));
    ASSERT_EQ(begun.pulses.size(), 1u) << "felt in the hand";
    ASSERT_EQ(begun.floating.size(), 2u) << "both sides of a blade";
    EXPECT_EQ(begun.floating[0].picture, RoomPicture::tile);
    frame(knife(0.02, 1.0f), 0.3);
    ASSERT_FALSE(shown_.empty());
    EXPECT_EQ(shown_.back().lasts, Lasts::forALook);
    EXPECT_EQ(planes(), 0u) << "not yet";
    TwoHands lost = knife(0.02, 1.0f);
    lost[1].grip.reset();
    frame(lost);
    EXPECT_EQ(shown_.back().lasts, Lasts::forGood);
    EXPECT_EQ(shown_.back().state, controls_->state()) << "all is back";
    EXPECT_EQ(changes_, 0);
}

TEST_F(RoomControlsTest, WhatIsLetGoWhileNobodyLooksCutsNothing) {
    frame(knife(0.02, 1.0f));
    frame(knife(0.02, 1.0f), 0.3);
    ASSERT_FALSE(shown_.empty());
    ASSERT_EQ(shown_.back().lasts, Lasts::forALook);
    controls_->interrupt();
    frame(knife(-0.3, 0.0f), 20.0);
    EXPECT_EQ(planes(), 0u);
    EXPECT_EQ(shown_.back().lasts, Lasts::forGood);
    EXPECT_EQ(shown_.back().state, controls_->state()) << "all is back";
    // What was grabbed does not jump to where the hand is by now.
    TwoHands hands;
    hands[0].grip = Pose{{-0.2, 1.2, -0.4}, {1, 0, 0, 0}};
    hands[0].squeeze = 1.0f;
    frame(hands);
    const glm::dmat4 held = placed_;
    controls_->goDark(seconds_);
    hands[0].grip->positionM.x = 0.5;
    frame(hands, 20.0);
    EXPECT_EQ(placed_, held);
    hands[0].grip->positionM.x = 0.6;
    frame(hands);
    EXPECT_NEAR(placed_[3].x - held[3].x, 0.1, 1e-9) << "and is held on";
    cutAt(0.02);
    EXPECT_EQ(planes(), 1u);
}

TEST_F(RoomControlsTest, APanelThatMovesToTheOtherWristEndsTheLookOfABall) {
    press(PanelButton::held);
    TwoHands hands = pointing(PanelButton::otherWrist, 0.0f);
    hands[0].trigger = 1.0f;
    frame(hands);
    frame(hands, 0.3);
    ASSERT_FALSE(shown_.empty());
    ASSERT_EQ(shown_.back().lasts, Lasts::forALook);
    hands = pointing(PanelButton::otherWrist, 1.0f);
    hands[0].trigger = 1.0f;
    frame(hands);
    ASSERT_EQ(controls_->panelHand(), 1u);
    EXPECT_EQ(shown_.back().lasts, Lasts::forGood);
    EXPECT_EQ(shown_.back().state, controls_->state());
    frame(pointing(PanelButton::otherWrist, 0.0f));
    EXPECT_EQ(controls_->state().clip, nullptr);
}

TEST_F(RoomControlsTest, TheOtherHandHoldsABallOrABox) {
    press(PanelButton::held);
    EXPECT_EQ(controls_->toolOf(0), ClipTool{"ball"});
    const auto use = [&] {
        TwoHands hands;
        hands[0].grip = Pose{{0.0, 1.6, -0.4}, {1, 0, 0, 0}};
        hands[0].trigger = 1.0f;
        const RoomFollowed held = frame(hands);
        hands[0].trigger = 0.0f;
        frame(hands);
        return held;
    };
    EXPECT_EQ(use().floating.front().picture, RoomPicture::ring);
    ASSERT_TRUE(controls_->state().clip && controls_->state().clip->ball);
    EXPECT_NEAR(controls_->state().clip->ball->radiusMm, 60.0, 1e-9);
    press(PanelButton::held);
    EXPECT_EQ(use().floating.size(), 6u);
    EXPECT_TRUE(controls_->state().clip->box);
    EXPECT_TRUE(controls_->state().clip->ball) << "both";
    press(PanelButton::held);
    EXPECT_EQ(controls_->toolOf(0), ClipTool::none);
}

TEST_F(RoomControlsTest, WhatWouldRemoveAllIsNotDoneAndSaid) {
    refuses_ = true;
    cutAt(0.0);
    EXPECT_EQ(planes(), 0u);
    EXPECT_EQ(changes_, 0);
    ASSERT_FALSE(notes_.empty());
    EXPECT_NE(notes_.back().find("Nothing would be left"), std::string::npos);
    const RoomFollowed told = frame({});
    ASSERT_EQ(told.floating.size(), 1u);
    EXPECT_EQ(told.floating[0].picture, RoomPicture::notice);
    EXPECT_TRUE(frame({}, 10.0).floating.empty()) << "for some seconds";
}

TEST_F(RoomControlsTest, ItSpeaksInTheWordsOfItsHost) {
    RoomWords german;
    german.shift = "Versatz";
    german.hold = "Halte: %1";
    german.say = [](const Text& text) { return text == "ball" ? std::string("Kugel") : text.english(); };
    german.quality = "Qualit\xc3\xa4t: %1";
    german.balanced = "ausgewogen";
    german.isBeforeYou = "Vor Ihnen.";
    german.larger = "%1-mal";
    german.edited = "bearbeitet";
    german.titles = {{"one", "eins"}};
    german.decimalSign = ',';
    begin(german);
    press(PanelButton::held);
    frame({});
    EXPECT_EQ(controls_->texts().preset, "eins");
    EXPECT_EQ(controls_->texts().held, "Halte: Kugel");
    EXPECT_EQ(controls_->texts().quality, "Qualit\xc3\xa4t: ausgewogen");
    press(PanelButton::shiftHigher);
    frame({});
    EXPECT_EQ(controls_->texts().preset, "eins (bearbeitet)");
    EXPECT_EQ(controls_->texts().shift.find("Versatz +"), 0u);
    press(PanelButton::recentre);
    EXPECT_EQ(notes_.back(), "Vor Ihnen.");
    placed_ = scaledAbout(placed_, glm::dvec3(0.0), 2.5);
    frame({});
    EXPECT_EQ(controls_->texts().size, "2,50-mal");
}

TEST_F(RoomControlsTest, SizeIsSaidAndGoesBackToReal) {
    TwoHands hands;
    for (const double apart : {0.2, 0.2, 0.5}) {
        hands[0].grip = Pose{{-0.5 * apart, 1.5, -0.5}, {1, 0, 0, 0}};
        hands[1].grip = Pose{{0.5 * apart, 1.5, -0.5}, {1, 0, 0, 0}};
        hands[0].squeeze = hands[1].squeeze = 1.0f;
        const RoomFollowed followed = frame(hands);
        if (apart == 0.5) {
            EXPECT_EQ(followed.floating.size(), 1u) << "how large it is";
        }
    }
    EXPECT_NEAR(scaleOf(placed_), 2.5, 1e-9);
    frame({});
    EXPECT_EQ(controls_->texts().size, "2.50 times real size");
    const glm::dvec3 middleM = transformPoint(placed_, kSeen.centre());
    press(PanelButton::realSize);
    EXPECT_NEAR(scaleOf(placed_), 1.0, 1e-9);
    EXPECT_NEAR(glm::distance(transformPoint(placed_, kSeen.centre()), middleM), 0.0, 1e-9);
    EXPECT_EQ(controls_->texts().size, "Real size 1:1");
    EXPECT_NE(notes_.back().find("1:1"), std::string::npos);
    press(PanelButton::recentre);
    const glm::dmat4 before = stageFromWorldBefore(kHead, kSeen);
    for (int column = 0; column < 4; ++column)
        EXPECT_NEAR(glm::distance(placed_[column], before[column]), 0.0, 1e-9);
}

TEST_F(RoomControlsTest, OfUncalibratedPixelsNoSizeIsClaimed) {
    begin({}, {preset("one")}, false);
    frame({});
    EXPECT_EQ(controls_->texts().size, RoomWords{}.notCalibrated);
    for (const PanelButton button : {PanelButton::realSize, PanelButton::recentre}) {
        press(button);
        EXPECT_EQ(controls_->texts().size, RoomWords{}.notCalibrated);
        ASSERT_FALSE(notes_.empty());
        EXPECT_EQ(notes_.back(), RoomWords{}.notCalibrated);
        notes_.clear();
    }
}

TEST_F(RoomControlsTest, TheOtherWristHasThePanelAndNoStrayCut) {
    press(PanelButton::held);  // a ball in the left hand
    frame(pointing(PanelButton::otherWrist, 0.0f));
    frame(pointing(PanelButton::otherWrist, 0.0f));
    frame(pointing(PanelButton::otherWrist, 1.0f));
    EXPECT_EQ(controls_->panelHand(), 1u);
    EXPECT_EQ(controls_->toolOf(1), ClipTool{"ball"});
    EXPECT_EQ(controls_->toolOf(0), ClipTool::knife);
    frame(pointing(PanelButton::otherWrist, 1.0f));
    frame(pointing(PanelButton::otherWrist, 0.0f));
    EXPECT_EQ(controls_->state().clip, nullptr);
}

TEST_F(RoomControlsTest, APictureIsAskedForOnce) {
    EXPECT_TRUE(press(PanelButton::picture).wantsPicture);
    EXPECT_FALSE(frame({}).wantsPicture);
}

TEST_F(RoomControlsTest, WhatWasChosenElsewhereIsAStepToo) {
    RoomState next;
    next.transferFunction = controls_->host().presets[2];
    wanted_ = next;
    frame({});
    EXPECT_EQ(presetName(), "three");
    EXPECT_EQ(changes_, 0) << "who wanted it knows";
    press(PanelButton::undo);
    EXPECT_EQ(presetName(), "one");
    wanted_ = RoomState{};
    frame({}, 1.0);
    EXPECT_EQ(presetName(), "one") << "without a preset it is none";
}

TEST_F(RoomControlsTest, ADragElsewhereIsOneStep) {
    RoomState next = controls_->state();
    for (int i = 1; i <= 10; ++i) {
        next.transferFunction = preset("dragged " + std::to_string(i));
        wanted_ = next;
        frame({}, 0.3);
        EXPECT_EQ(presetName(), "dragged " + std::to_string(i));
    }
    next.transferFunction = preset("too soon");
    wanted_ = next;
    frame({}, 0.01);
    EXPECT_EQ(presetName(), "dragged 10") << "a headset has no time for each of them";
    frame({}, 0.3);
    EXPECT_EQ(presetName(), "too soon") << "the last one comes";
    cutAt(0.02);
    press(PanelButton::undo);
    press(PanelButton::undo);
    EXPECT_EQ(presetName(), "one");
}

TEST_F(RoomControlsTest, ATurnWhileItIsHeldDoesNotJumpBack) {
    TwoHands hands;
    hands[1].grip = Pose{{0.1, 1.5, -0.5}, {1, 0, 0, 0}};
    hands[1].squeeze = 1.0f;
    frame(hands);
    frame(hands);
    hands[0].turn = 1.0f;
    frame(hands);
    const glm::dmat4 turned = placed_;
    frame(hands);
    frame(hands);
    for (int column = 0; column < 4; ++column)
        EXPECT_NEAR(glm::distance(placed_[column], turned[column]), 0.0, 1e-9);
}

TEST_F(RoomControlsTest, LostTrackingGoesDarkAndIsSaid) {
    frame({});
    RoomFollowed lost;
    for (int i = 0; i < 40; ++i) lost = frame({}, 0.01, false);
    EXPECT_EQ(lost.light, 0.0);
    ASSERT_EQ(lost.floating.size(), 1u);
    EXPECT_EQ(lost.floating[0].picture, RoomPicture::notice);
    for (int i = 0; i < 40; ++i) lost = frame({}, 0.01, true);
    EXPECT_EQ(lost.light, 1.0);
}

TEST(RoomHistory, ForgetsTheOldestStepsAndNothingElse) {
    RoomState state;
    state.transferFunction = preset("0");
    RoomHistory history(state);
    EXPECT_FALSE(history.canUndo());
    history.push(state);
    EXPECT_FALSE(history.canUndo()) << "the same";
    for (int i = 1; i <= 300; ++i) {
        state.transferFunction = preset(std::to_string(i));
        history.push(state);
    }
    int undone = 0;
    for (; history.canUndo(); ++undone) history.undo();
    EXPECT_EQ(undone, int(RoomHistory::kMostSteps));
    EXPECT_EQ(history.now().transferFunction->name, "100");
}

}  // namespace
}  // namespace macula::xr
