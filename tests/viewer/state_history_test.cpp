// The steps that a person can take back.
#include "viewer/session/state_history.h"

#include <gtest/gtest.h>

namespace macula::viewer {
namespace {

const QString kSlab = QStringLiteral("Slab");
const QString kLayout = QStringLiteral("Layout");

app::StudyState thick(double mm) {
    app::StudyState state;
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
    app::StudyState axial = thick(1);
    axial.layout = app::Layout::axial;
    EXPECT_TRUE(history.push(kLayout, axial));
    EXPECT_EQ(history.undoText(), kLayout);
    history.undo();
    EXPECT_EQ(history.now(), thick(1));
    EXPECT_EQ(history.undoText(), kSlab);
    EXPECT_EQ(history.redoText(), kLayout);
    history.undo();
    EXPECT_EQ(history.now(), app::StudyState());
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
    EXPECT_EQ(history.now(), app::StudyState());
}

// With a step after it, which stays: the undo goes to before what was not to be had.
TEST(StateHistory, WhatIsNotToBeHadIsNoStep) {
    StateHistory history;
    history.push(kSlab, thick(1));
    history.push(kSlab, thick(9));
    app::StudyState axial = thick(9);
    axial.layout = app::Layout::axial;
    history.push(kLayout, axial);
    EXPECT_TRUE(history.correct([](app::StudyState& each) {
        if (each.slices.slab.thicknessMm == 9) each.slices.slab.thicknessMm = 1;
    }));
    EXPECT_EQ(thicknessMm(history), 1);
    EXPECT_EQ(history.undoText(), kLayout);
    EXPECT_FALSE(history.canRedo());
    history.undo();
    EXPECT_EQ(history.now(), thick(1));
    EXPECT_FALSE(history.correct([](app::StudyState&) {}));
    EXPECT_EQ(undoAll(history), 1);
    EXPECT_EQ(history.now(), app::StudyState());
    history.redo();
    history.redo();
    EXPECT_EQ(history.now().layout, app::Layout::axial);
}

}  // namespace
}  // namespace macula::viewer
