// The steps that a person can take back.
#include "viewer/editor/state_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace macula::viewer {
namespace {

const QString kSlab = QStringLiteral("Slab");
const QString kLayout = QStringLiteral("Layout");

scene::StudyState thick(double mm) {
    scene::StudyState state;
    state.slices.slab.thicknessMm = mm;
    return state;
}

double thicknessMm(const StateHistory& history) {
    return history.now().slices.slab.thicknessMm;
}

int undoAll(StateHistory& history) {
    int steps = 0;
    for (; history.canUndo(); ++steps) history.undo();
    return steps;
}

TEST(StateHistory, HasNothingToUndoAtFirst) {
    StateHistory history;
    EXPECT_FALSE(history.canUndo());
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(history.undoText(), QString());
    history.begin(thick(3));
    EXPECT_EQ(thicknessMm(history), 3);
    EXPECT_FALSE(history.canUndo());
    EXPECT_FALSE(history.canRedo());
}

TEST(StateHistory, GoesBackAndForth) {
    StateHistory history;
    EXPECT_TRUE(history.push(kSlab, thick(1)));
    scene::StudyState axial = thick(1);
    axial.layout = scene::Layout::axial;
    EXPECT_TRUE(history.push(kLayout, axial));
    EXPECT_EQ(history.undoText(), kLayout);
    history.undo();
    EXPECT_EQ(history.now(), thick(1));
    EXPECT_EQ(history.undoText(), kSlab);
    EXPECT_EQ(history.redoText(), kLayout);
    history.undo();
    EXPECT_EQ(history.now(), scene::StudyState());
    EXPECT_FALSE(history.canUndo());
    history.redo();
    history.redo();
    EXPECT_EQ(history.now(), axial);
    EXPECT_FALSE(history.canRedo());
}

TEST(StateHistory, TheSameStateIsNoStep) {
    StateHistory history;
    history.push(kSlab, thick(1));
    EXPECT_FALSE(history.push(kLayout, thick(1)));
    EXPECT_EQ(history.undoText(), kSlab);
    history.undo();
    EXPECT_FALSE(history.push(kLayout, thick(0)));
    EXPECT_TRUE(history.canRedo()) << "nothing was changed";
}

TEST(StateHistory, ADragIsOneStep) {
    StateHistory history;
    for (const double mm : {1, 2, 3}) EXPECT_TRUE(history.push(kSlab, thick(mm), true));
    EXPECT_EQ(thicknessMm(history), 3);
    EXPECT_EQ(undoAll(history), 1);
    EXPECT_EQ(thicknessMm(history), 0);
    history.redo();
    EXPECT_EQ(thicknessMm(history), 3);
}

TEST(StateHistory, ADragEndsWithItsEndAnotherOneAndAnUndo) {
    StateHistory history;
    history.push(kSlab, thick(1), true);
    history.endJoining();
    history.push(kSlab, thick(2), true);
    history.push(kLayout, thick(3), true);
    history.push(kSlab, thick(4), true);
    EXPECT_EQ(undoAll(history), 4);
    history.redo();
    history.push(kSlab, thick(5), true);
    EXPECT_EQ(undoAll(history), 2) << "what was done again is not gone on with";
}

TEST(StateHistory, ADragDoesNotGoOnWithAChangeBeforeIt) {
    StateHistory history;
    history.push(kSlab, thick(1));
    history.push(kSlab, thick(1), true);  // the hand has not moved yet
    history.push(kSlab, thick(2), true);
    history.push(kSlab, thick(3), true);
    EXPECT_EQ(undoAll(history), 2);
    history.push(kSlab, thick(4), true);
    EXPECT_FALSE(history.push(kSlab, thick(4), true));  // rests on its way
    history.push(kSlab, thick(5), true);
    EXPECT_EQ(undoAll(history), 1);
}

TEST(StateHistory, AChangeAfterAnUndoDropsWhatWouldHaveBeenDoneAgain) {
    StateHistory history;
    for (const double mm : {1, 2, 3}) history.push(kSlab, thick(mm));
    history.undo();
    history.undo();
    history.push(kLayout, thick(9));
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(history.redoText(), QString());
    history.undo();
    EXPECT_EQ(thicknessMm(history), 1);
}

TEST(StateHistory, ForgetsTheOldestOfTooMany) {
    StateHistory history;
    const int pushed = int(kMostSteps) + 25;
    for (int mm = 1; mm <= pushed; ++mm) history.push(kSlab, thick(mm));
    EXPECT_EQ(thicknessMm(history), pushed);
    EXPECT_EQ(undoAll(history), int(kMostSteps));
    EXPECT_EQ(thicknessMm(history), 25);
    EXPECT_TRUE(history.canRedo());
    history.begin(thick(1));
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(undoAll(history), 0);
}

// A star with as many points as an outline may have.
scene::SharedOutline outlineOf(double size) {
    std::vector<glm::dvec2> points;
    for (std::size_t i = 0; i < scene::kMostOutlinePoints; ++i) {
        const double turn = double(i) / double(scene::kMostOutlinePoints) * 6.28;
        points.emplace_back(size * std::cos(turn), size * std::sin(turn));
    }
    return points;
}

// The most cuts that there may be, and then other things are changed.
TEST(StateHistory, StepsShareTheOutlinesOfScissors) {
    constexpr std::size_t kOutlineBytes = scene::kMostOutlinePoints * sizeof(glm::dvec2);
    StateHistory history;
    scene::StudyState state;
    for (std::size_t i = 0; i < scene::kMostScissorCuts; ++i) {
        state.cuts.scissors.push_back({.camera = {}, .outline = outlineOf(1.0 + double(i))});
        history.push(QStringLiteral("Scissors"), state);
    }
    const std::size_t cut = history.bytes();
    EXPECT_GE(cut, scene::kMostScissorCuts * kOutlineBytes);
    EXPECT_LT(cut, 4 * scene::kMostScissorCuts * kOutlineBytes) << "each of them once, not 25 times";
    for (int mm = 1; mm <= 100; ++mm) {
        state.slices.slab.thicknessMm = mm;
        history.push(kSlab, state);
    }
    EXPECT_LT(history.bytes() - cut,
              100 * 2 * (sizeof state + scene::kMostScissorCuts * sizeof(scene::ScissorCut)));
    EXPECT_EQ(undoAll(history), 150);
    // What nobody can go to any more is gone.
    history.push(kSlab, thick(2));
    EXPECT_LT(history.bytes(), kOutlineBytes);
    EXPECT_EQ(history.now().cuts.scissors.size(), 0u);
}

TEST(StateHistory, ForgetsTheOldestOfStepsThatAreTooLargeTogether) {
    StateHistory history;
    scene::StudyState large;
    large.otherKeys.assign(kMostHistoryBytes / 4, ' ');
    for (int mm = 1; mm <= 10; ++mm) {
        large.slices.slab.thicknessMm = mm;
        history.push(kSlab, large);
        EXPECT_LE(history.bytes(), kMostHistoryBytes);
    }
    EXPECT_EQ(thicknessMm(history), 10);
    EXPECT_EQ(undoAll(history), 2) << "three of a little more than a quarter have room";
    EXPECT_EQ(thicknessMm(history), 8);
    // Each alone is too large: the present stays, and the one before it.
    large.otherKeys.assign(kMostHistoryBytes + 1, ' ');
    history.begin(large);
    for (int mm = 21; mm <= 23; ++mm) {
        large.slices.slab.thicknessMm = mm;
        history.push(kSlab, large);
    }
    EXPECT_EQ(undoAll(history), 1);
    EXPECT_EQ(thicknessMm(history), 22);
}

TEST(StateHistory, CountsWhatIsPutInThePlaceOfAnother) {
    StateHistory history;
    scene::StudyState state;
    const std::size_t empty = history.bytes();
    state.cuts.scissors.push_back({.camera = {}, .outline = outlineOf(1.0)});
    history.push(kSlab, state, true);
    const std::size_t one = history.bytes();
    state.cuts.scissors[0].outline = outlineOf(2.0);
    history.push(kSlab, state, true);
    EXPECT_EQ(history.bytes(), one) << "it took the place of the other";
    history.correct([](scene::StudyState& next) { next.cuts = {}; });
    EXPECT_EQ(history.bytes(), empty) << "the step was of nothing else";
    history.begin({});
    EXPECT_EQ(history.bytes(), empty);
}

TEST(StateHistory, CountsThePresetOfASecondVolumeOnce) {
    auto preset = std::make_shared<TransferFunction>();
    preset->document.assign(100'000, ' ');
    StateHistory history;
    scene::StudyState state;
    state.secondVolume.emplace();
    state.secondVolume->preset = std::move(preset);
    for (const double opacity : {0.1, 0.2, 0.3}) {
        state.secondVolume->opacity = opacity;
        history.push(kSlab, state);
    }
    EXPECT_GT(history.bytes(), 100'000u);
    EXPECT_LT(history.bytes(), 200'000u);
}

TEST(StateHistory, WhatComesOfItselfIsNoStep) {
    StateHistory history;
    history.push(kSlab, thick(1));
    history.push(kSlab, thick(2));
    history.undo();
    EXPECT_TRUE(history.amend(thick(7)));
    EXPECT_FALSE(history.amend(thick(7)));
    EXPECT_EQ(thicknessMm(history), 7);
    EXPECT_TRUE(history.canRedo());
    EXPECT_EQ(undoAll(history), 1);
    EXPECT_EQ(history.now(), scene::StudyState());
}

// With a step after it, which stays: the undo goes to before what was not to be had.
TEST(StateHistory, WhatIsNotToBeHadIsNoStep) {
    StateHistory history;
    history.push(kSlab, thick(1));
    history.push(kSlab, thick(9));
    scene::StudyState axial = thick(9);
    axial.layout = scene::Layout::axial;
    history.push(kLayout, axial);
    EXPECT_TRUE(history.correct([](scene::StudyState& each) {
        if (each.slices.slab.thicknessMm == 9) each.slices.slab.thicknessMm = 1;
    }));
    EXPECT_EQ(thicknessMm(history), 1);
    EXPECT_EQ(history.undoText(), kLayout);
    EXPECT_FALSE(history.canRedo());
    history.undo();
    EXPECT_EQ(history.now(), thick(1));
    EXPECT_FALSE(history.correct([](scene::StudyState&) {}));
    EXPECT_EQ(undoAll(history), 1);
    EXPECT_EQ(history.now(), scene::StudyState());
    history.redo();
    history.redo();
    EXPECT_EQ(history.now().layout, scene::Layout::axial);
}

}  // namespace
}  // namespace macula::viewer
