// What is shown when: the rules, driven by a made-up hand and clock.
#include "live/frame/picture_course.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace macula::live {
namespace {

using std::chrono::milliseconds;

class PictureCourseTest : public testing::Test {
  protected:
    PictureCourse course_;
    PictureCourse::TimePoint now_{};
    int samples_ = 0;  // of the full picture

    Step next() const { return course_.next(now_); }
    // As the renderer does it, each in 20 ms. What was done.
    Step go(bool isWorthShowing = false, bool hasConverged = false) {
        const Step step = next();
        now_ += milliseconds(20);
        switch (step) {
            case Step::showModel:
                course_.showedModel();
                break;
            case Step::showPreview:
                course_.showedPreview(++samples_, now_);
                break;
            case Step::search:
                course_.searched();
                course_.spent(step, 20.0);
                break;
            case Step::trace:
                course_.spent(step, 20.0);
                if (isWorthShowing) course_.traced(hasConverged);
                break;
            case Step::showTraced:
                course_.showedTraced();
                break;
            case Step::fade:
                course_.faded(now_);
                break;
            case Step::learn:
            case Step::learnPhases:
                course_.spent(step, 20.0);
                break;
            case Step::traceFovea:
            case Step::none:
                break;
        }
        return step;
    }
    void want(bool isTraced = false) {
        samples_ = 0;
        course_.want(isTraced);
    }
};

TEST_F(PictureCourseTest, BetweenFramesInMotionTheFoveaIsTraced) {
    course_.setModel(ModelState::ready, true);
    course_.setHand(true);
    course_.setFovea(true);
    want();
    EXPECT_EQ(go(), Step::showModel);
    EXPECT_EQ(go(), Step::traceFovea);
    EXPECT_EQ(go(), Step::traceFovea);
    want();  // the hand has moved on: the frame that shows it comes first
    EXPECT_EQ(go(), Step::showModel);
    EXPECT_EQ(go(), Step::traceFovea);
    course_.setFovea(false);  // it is of this view
    EXPECT_EQ(go(), Step::none);
    course_.setFovea(true);
    course_.setHand(false);
    EXPECT_EQ(go(), Step::traceFovea);  // at rest it grows
    course_.setFovea(false);
    EXPECT_EQ(go(), Step::trace);  // all pixels are better
    course_.setFovea(true);
    course_.setHand(true);
    course_.setModel(ModelState::none, false);
    want();
    EXPECT_EQ(go(), Step::showPreview);  // without a model there is no frame to put it in
}

TEST_F(PictureCourseTest, InMotionTheModelIsShownOnceForEachViewAndNothingElseIsDone) {
    course_.setModel(ModelState::ready, true);
    course_.setHand(true);
    for (int view = 0; view < 3; ++view) {
        want();
        EXPECT_EQ(go(), Step::showModel);
        EXPECT_EQ(course_.onScreen(), OnScreen::model);
        // Neither learning nor tracing while a hand has it.
        EXPECT_EQ(next(), Step::none);
    }
}

// On a graphics card a frame takes a few milliseconds of the hand's sixteen.
TEST_F(PictureCourseTest, WhatAFrameInMotionLeavesIsForLearning) {
    course_.setModel(ModelState::ready, true);
    course_.setHand(true);
    course_.setFovea(true);
    course_.setLearnsBesideHand(true);
    for (int view = 0; view < 3; ++view) {
        want();
        EXPECT_EQ(go(), Step::showModel) << "first the frame";
        EXPECT_EQ(go(), Step::traceFovea) << "then the fovea";
        course_.setFovea(false);
        EXPECT_EQ(go(), Step::learn);
        course_.setLearnsBesideHand(false);  // the next input is due
        EXPECT_EQ(next(), Step::none);
        course_.setFovea(true);
        course_.setLearnsBesideHand(true);
    }
    course_.setHand(false);
    course_.setFovea(false);
    EXPECT_EQ(next(), Step::trace) << "at rest the picture comes first";
}

// Where all pixels are soon there, nobody waits while small pictures are refined or a model is searched for.
TEST_F(PictureCourseTest, WhereItIsQuickThePictureOfAllPixelsWaitsForNothing) {
    course_.setPreviewLimit(64);
    course_.setQuick(true);
    for (const ModelState state : {ModelState::none, ModelState::searching}) {
        course_.setModel(state, state == ModelState::searching);
        want();
        EXPECT_EQ(go(), Step::showPreview);
        EXPECT_EQ(go(true), Step::trace);
        EXPECT_EQ(course_.onScreen(), OnScreen::traced);
        EXPECT_EQ(next(), state == ModelState::searching ? Step::search : Step::trace);
        int searched = 0;
        for (int i = 0; i < 60; ++i) searched += go() == Step::search ? 1 : 0;
        EXPECT_NEAR(searched, state == ModelState::searching ? 40 : 0, 2)
            << "nor does the picture for the search";
    }
    // In motion small pictures come as ever.
    course_.setHand(true);
    want();
    EXPECT_EQ(go(), Step::showPreview);
    EXPECT_EQ(go(), Step::search);
    EXPECT_EQ(go(), Step::showPreview);
}

TEST_F(PictureCourseTest, WhereItIsQuickAYoungModelHasMostOfTheTime) {
    course_.setPreviewLimit(64);
    course_.setQuick(true);
    course_.setModel(ModelState::young, true);
    want();
    EXPECT_EQ(go(), Step::showPreview);
    EXPECT_EQ(go(true), Step::trace) << "the picture is first";
    const auto learntOf = [&](int turns) {
        int learnt = 0;
        for (int i = 0; i < turns; ++i) learnt += go() == Step::learn ? 1 : 0;
        return learnt;
    };
    EXPECT_GE(learntOf(40), 20) << "at least half";
    EXPECT_NEAR(learntOf(40), 30, 2);
    course_.setModel(ModelState::ready, true);
    for (int i = 0; i < 60; ++i) go();
    EXPECT_NEAR(learntOf(40), 20, 2) << "one that can be shown takes turns";
    course_.setModel(ModelState::ready, false);
    EXPECT_EQ(learntOf(10), 0);
}

TEST_F(PictureCourseTest, WhenTheHandStopsTheModelStaysUntilThePictureIsWorthShowingAndFadesIntoIt) {
    course_.setModel(ModelState::ready, true);
    course_.setHand(true);
    want();
    go();
    course_.setHand(false);
    // First the picture, however much there is to learn.
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(go(), Step::trace);
        EXPECT_EQ(course_.onScreen(), OnScreen::model);
    }
    EXPECT_EQ(go(true), Step::trace);
    EXPECT_EQ(course_.onScreen(), OnScreen::fading);
    double share = -1.0;
    int frames = 0;
    while (course_.onScreen() == OnScreen::fading) {
        EXPECT_GE(course_.tracedShare(now_), share);
        share = course_.tracedShare(now_);
        EXPECT_EQ(go(), Step::fade);
        ++frames;
    }
    EXPECT_GE(frames, 5);
    EXPECT_LE(frames, 15);
    EXPECT_EQ(course_.onScreen(), OnScreen::traced);
    EXPECT_EQ(course_.tracedShare(now_), 1.0);
    // From then on both in turns.
    int traced = 0;
    int learnt = 0;
    for (int i = 0; i < 20; ++i) {
        const Step step = go();
        traced += step == Step::trace ? 1 : 0;
        learnt += step == Step::learn ? 1 : 0;
    }
    EXPECT_EQ(traced + learnt, 20);
    EXPECT_NEAR(traced, learnt, 2);
}

TEST_F(PictureCourseTest, BothGoOnUntilBothAreDone) {
    course_.setModel(ModelState::ready, true);
    want();
    go();
    go(true, true);
    while (next() == Step::fade) go();
    EXPECT_TRUE(course_.hasConverged());
    EXPECT_EQ(go(), Step::learn);
    EXPECT_EQ(go(), Step::learn);
    course_.setModel(ModelState::ready, false);
    EXPECT_EQ(next(), Step::none);
    course_.goOnTracing();
    EXPECT_FALSE(course_.hasConverged());
    EXPECT_EQ(next(), Step::trace);
    // A hand that holds it will move it: no learning.
    course_.goOnTracing();
    course_.setModel(ModelState::ready, true);
    course_.setHand(true);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(go(true), Step::trace);
    go(true, true);
    EXPECT_EQ(next(), Step::none);
}

TEST_F(PictureCourseTest, OtherPhasesAreLearntOverATracedPictureAndHaveMostOfTheTime) {
    course_.setPhases(true);
    course_.setModel(ModelState::ready, true);
    want();
    EXPECT_EQ(go(), Step::showModel);
    EXPECT_EQ(go(true), Step::trace);
    while (course_.onScreen() == OnScreen::fading) go();
    std::map<Step, int> taken;
    for (int i = 0; i < 160; ++i) ++taken[go(true)];
    EXPECT_NEAR(taken[Step::learnPhases], 120, 4);
    EXPECT_NEAR(taken[Step::trace], 20, 4);
    EXPECT_NEAR(taken[Step::learn], 20, 4);
    course_.setHand(true);
    EXPECT_NE(next(), Step::learnPhases);
    course_.setHand(false);
    course_.setModel(ModelState::young, true);
    EXPECT_NE(next(), Step::learnPhases) << "the phase on screen comes first";
    course_.setModel(ModelState::ready, false);
    go(true, true);
    while (next() == Step::trace) go(true, true);
    for (int i = 0; i < 40; ++i) EXPECT_EQ(go(), Step::learnPhases) << "nothing else is left";
    course_.setPhases(false);
    EXPECT_EQ(next(), Step::none);
}

TEST_F(PictureCourseTest, APictureOfExactlyThisViewIsShownAtOnceWhenTheHandRests) {
    course_.setModel(ModelState::ready, false);
    want(true);
    EXPECT_EQ(go(), Step::showTraced);
    EXPECT_EQ(course_.onScreen(), OnScreen::traced);
    // Dragged there and back: in motion the model, then the picture that there was.
    course_.setHand(true);
    want(false);
    EXPECT_EQ(go(), Step::showModel);
    want(true);
    EXPECT_EQ(go(), Step::showModel);
    EXPECT_EQ(next(), Step::none);
    course_.setHand(false);
    EXPECT_EQ(go(), Step::showTraced);
}

TEST_F(PictureCourseTest, AConvergedPictureStaysConvergedThereAndBackAndIsForgottenElsewhere) {
    course_.setModel(ModelState::ready, false);
    want();
    go();
    go(true, true);
    while (next() == Step::fade) go();
    EXPECT_EQ(next(), Step::none);
    want(true);
    EXPECT_EQ(go(), Step::showTraced);
    EXPECT_EQ(next(), Step::none);
    want(false);
    EXPECT_EQ(go(), Step::showModel);
    EXPECT_EQ(next(), Step::trace);
}

TEST_F(PictureCourseTest, WithoutAModelItIsSearchedForInTurnsWithSmallPicturesAndThenTakesTheirPlace) {
    course_.setPreviewLimit(64);
    course_.setModel(ModelState::searching, true);
    course_.setHand(true);
    for (int view = 0; view < 3; ++view) {
        want();
        EXPECT_EQ(go(), Step::showPreview);
        EXPECT_EQ(go(), Step::search);
        EXPECT_EQ(go(), Step::showPreview);
        EXPECT_EQ(go(), Step::search);
    }
    // At rest a few more samples are, and then nothing is in its way.
    course_.setHand(false);
    want();
    for (std::uint64_t i = 0; i < PictureCourse::kRefinedWhileSearching; ++i) {
        EXPECT_EQ(go(), Step::showPreview);
        EXPECT_EQ(go(), Step::search);
    }
    for (int i = 0; i < 10; ++i) EXPECT_EQ(go(), Step::search);
    course_.setModel(ModelState::ready, true);
    EXPECT_EQ(go(), Step::showModel);
    EXPECT_EQ(go(), Step::trace);
}

// Mottled as it is it would be taken for illness: the small picture stays, and the traced one follows it.
TEST_F(PictureCourseTest, AYoungModelIsNeverShownAndLearnsBesideTheFirstTracedPicture) {
    course_.setPreviewLimit(64);
    course_.setModel(ModelState::young, true);
    want();
    while (next() == Step::showPreview) go();
    // Nothing comes before it for a while.
    double firstMs = 0.0;
    for (; next() == Step::learn && firstMs < 60000.0; go()) firstMs += 20.0;
    EXPECT_NEAR(firstMs, PictureCourse::kYoungFirstMs, 20.0);
    const double owedMs = PictureCourse::kYoungFirstMs / PictureCourse::kYoungShare;
    for (double ms = 0.0; ms < owedMs; ms += 20.0) EXPECT_EQ(go(), Step::trace);
    int traced = 0;
    int learnt = 0;
    for (int i = 0; i < 30; ++i) {
        const Step step = go();
        EXPECT_EQ(course_.onScreen(), OnScreen::preview);
        traced += step == Step::trace ? 1 : 0;
        learnt += step == Step::learn ? 1 : 0;
    }
    EXPECT_EQ(traced + learnt, 30);
    EXPECT_NEAR(learnt, PictureCourse::kYoungShare * traced, 2.0) << "the picture is not forgotten";
    while (next() == Step::learn) go();
    EXPECT_EQ(go(true), Step::trace);
    EXPECT_EQ(course_.onScreen(), OnScreen::traced) << "there is nothing that could fade";
    int turns = 0;
    for (int i = 0; i < 30; ++i) turns += go() == Step::learn ? 1 : 0;
    EXPECT_NEAR(turns, 20, 1);
}

TEST_F(PictureCourseTest, ATracedPictureWaitsOnlySoLongForSearchAndLearning) {
    for (const ModelState state : {ModelState::searching, ModelState::young}) {
        course_ = {};
        course_.setPreviewLimit(64);
        course_.setModel(state, true);
        want();
        double firstMs = 0.0;
        while (next() != Step::trace && firstMs < 60000.0) {
            const Step step = go();
            firstMs += step == Step::learn || step == Step::search ? 20.0 : 0.0;
        }
        EXPECT_NEAR(firstMs, PictureCourse::kYoungFirstMs, 20.0);
        double learntMs = 0.0;
        for (double ms = 0.0; ms < 9000.0 + firstMs; ms += 20.0) {
            const Step step = go();
            ASSERT_NE(step, Step::showPreview) << "it would be drawn where the full one is traced";
            learntMs += step == Step::learn || step == Step::search ? 20.0 : 0.0;
        }
        const double share = PictureCourse::kYoungShare;
        EXPECT_NEAR(firstMs + learntMs, share * (9000.0 + firstMs - learntMs), 100.0)
            << "neither is forgotten";
    }
}

TEST_F(PictureCourseTest, NoSmallPictureFollowsOnceTheFullOneIsBegun) {
    for (const ModelState state : {ModelState::none, ModelState::searching, ModelState::young}) {
        course_ = {};
        course_.setPreviewLimit(64);
        course_.setModel(state, state != ModelState::none);
        want();
        for (int i = 0; i < 2000 && next() != Step::trace; ++i) go();
        EXPECT_EQ(go(), Step::trace);
        EXPECT_NE(course_.onScreen(), OnScreen::traced);
        course_.setHand(true);  // pressed, and not yet moved
        for (int i = 0; i < 20; ++i) EXPECT_NE(go(), Step::showPreview) << int(state);
    }
}

TEST_F(PictureCourseTest, WhileAHandMovesAYoungModelLearnsInTurnsWithSmallPictures) {
    course_.setPreviewLimit(64);
    course_.setModel(ModelState::young, true);
    course_.setHand(true);
    for (int view = 0; view < 3; ++view) {
        want();
        EXPECT_EQ(go(), Step::showPreview);
        EXPECT_EQ(go(), Step::learn);
        EXPECT_EQ(go(), Step::showPreview);
        EXPECT_EQ(go(), Step::learn);
    }
    // It has learnt enough: it takes the small picture's place, also while the hand is there.
    course_.setModel(ModelState::ready, true);
    EXPECT_EQ(go(), Step::showModel);
    // One that learns no more, for lack of memory, is not shown either.
    course_.setModel(ModelState::young, false);
    course_.setPreviewLimit(2);
    want();
    EXPECT_EQ(go(), Step::showPreview);
    EXPECT_EQ(go(), Step::showPreview);
    EXPECT_EQ(next(), Step::none);
    course_.setHand(false);
    EXPECT_EQ(next(), Step::trace);
}

// There is nothing to see, no room, or nobody wants one: as it was before there were models.
TEST_F(PictureCourseTest, WithoutAnyModelASmallPictureSettlesAndTheFullOneFollows) {
    course_.setPreviewLimit(64);
    course_.setModel(ModelState::none, false);
    want();
    const auto began = now_;
    while (next() == Step::showPreview) go();
    EXPECT_GE(now_ - began, PictureCourse::kSettle);
    EXPECT_LT(now_ - began, PictureCourse::kSettle + milliseconds(100));
    EXPECT_EQ(go(true), Step::trace);
    EXPECT_EQ(course_.onScreen(), OnScreen::traced);
    // In motion they are refined as far as that is worth it.
    course_.setHand(true);
    course_.setPreviewLimit(3);
    want();
    for (int i = 0; i < 3; ++i) EXPECT_EQ(go(), Step::showPreview);
    EXPECT_EQ(next(), Step::none);
}

TEST_F(PictureCourseTest, ASmallPictureIsNeverShownWhereThereIsAModel) {
    course_.setModel(ModelState::ready, true);
    for (const bool moves : {true, false, true}) {
        course_.setHand(moves);
        want();
        for (int i = 0; i < 30; ++i) EXPECT_NE(go(i % 7 == 3), Step::showPreview);
    }
    // The device has no room for it any more.
    course_.setModel(ModelState::none, false);
    course_.setHand(true);
    want();
    EXPECT_EQ(go(), Step::showPreview);
}

// Another preset or study: the model of before is not asked for, and the next one shows at once when it is
// there.
TEST_F(PictureCourseTest, AfterAChangeNothingOfBeforeIsShown) {
    course_.setModel(ModelState::ready, true);
    want();
    go();
    go(true, true);
    while (next() == Step::fade) go();
    course_.setModel(ModelState::searching, true);
    want(false);
    EXPECT_EQ(course_.onScreen(), OnScreen::nothing);
    EXPECT_FALSE(course_.hasConverged());
    EXPECT_EQ(go(), Step::showPreview);
    course_.setModel(ModelState::ready, true);
    EXPECT_EQ(go(), Step::showModel);
}

TEST_F(PictureCourseTest, AFadeIsLeftAtOnceWhenAnotherViewIsWanted) {
    course_.setModel(ModelState::ready, true);
    want();
    go();
    go(true);
    EXPECT_EQ(course_.onScreen(), OnScreen::fading);
    course_.setHand(true);
    want();
    EXPECT_EQ(go(), Step::showModel);
    EXPECT_EQ(next(), Step::none);
}

// As after another preset was chosen: the model of before tells what it looks like.
TEST_F(PictureCourseTest, AnEstimateStandsForTheModelUntilThatIsFit) {
    course_.setModel(ModelState::searching, true);
    course_.setEstimate(true);
    want();
    ASSERT_EQ(next(), Step::showModel);
    course_.showedEstimate();
    EXPECT_EQ(course_.onScreen(), OnScreen::estimate);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(go(), Step::search);
    course_.setModel(ModelState::young, true);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(go(), Step::learn);
    course_.setHand(true);
    // It is what a hand wants; a slice of learning follows each frame.
    EXPECT_EQ(next(), Step::none) << "there was one already";
    want();
    course_.showedEstimate();
    EXPECT_EQ(go(), Step::learn);
    EXPECT_EQ(next(), Step::none);
    course_.setHand(false);
    course_.setModel(ModelState::ready, true);
    course_.setEstimate(false);
    EXPECT_EQ(go(), Step::showModel);
    EXPECT_EQ(go(), Step::trace);
}

TEST_F(PictureCourseTest, SearchAndLearningOverAnEstimateTakeTurnsWithTracingInTheEnd) {
    course_.setModel(ModelState::searching, true);
    course_.setEstimate(true);
    want();
    course_.showedEstimate();
    const auto start = now_;
    while (next() == Step::search) go();
    EXPECT_EQ(next(), Step::trace);
    EXPECT_NEAR(std::chrono::duration<double>(now_ - start).count(), PictureCourse::kYoungFirstMs / 1000.0,
                0.1);
    EXPECT_EQ(go(true), Step::trace);
    EXPECT_EQ(course_.onScreen(), OnScreen::fading);
}

TEST_F(PictureCourseTest, WithoutItsEstimateASmallPictureIsNext) {
    course_.setEstimate(true);
    want();
    course_.showedEstimate();
    EXPECT_EQ(next(), Step::trace) << "no model is searched for";
    course_.setEstimate(false);
    EXPECT_EQ(go(), Step::showPreview);
    EXPECT_EQ(course_.onScreen(), OnScreen::preview);
}

}  // namespace
}  // namespace macula::live
