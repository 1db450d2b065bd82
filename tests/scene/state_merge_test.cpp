// One study in two windows: nothing that was measured in either is lost.
#include "scene/state/state_merge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/state/study_state.h"

namespace macula::scene {
namespace {

slices::Measurement distance(double lengthMm, const std::string& label = {}) {
    return {.label = label,
            .shape = slices::Distance{.endsMm = {glm::dvec3(0.0), glm::dvec3(lengthMm, 0.0, 0.0)}}};
}

// In mm, in their order.
std::vector<double> lengthsIn(const StudyState& state) {
    std::vector<double> lengths;
    for (const slices::Measurement& each : state.measurements)
        lengths.push_back(slices::lengthMm(std::get<slices::Distance>(each.shape)));
    std::ranges::sort(lengths);
    return lengths;
}

StudyState with(std::vector<slices::Measurement> measurements) {
    StudyState state;
    state.measurements = std::move(measurements);
    return state;
}

StudyState merged(const StudyState& base, const StudyState& mine, const StudyState& theirs,
                  bool holdsMore = false) {
    const auto both = mergedState(toJson(base), toJson(mine), toJson(theirs));
    if (!both) {
        ADD_FAILURE() << "too much";
        return {};
    }
    EXPECT_EQ(both->holdsMore, holdsMore);
    const auto read = studyStateFromJson(both->json, {});
    EXPECT_TRUE(read.ok());
    return read.ok() ? *read : StudyState{};
}

using Lengths = std::vector<double>;

TEST(MergedState, WhereNobodyElseHasChangedAnythingItIsTheOwnTextToTheLetter) {
    const StudyState base = with({distance(10.0)});
    const std::string mine = toJson(with({distance(10.0), distance(20.0)}));
    for (const std::string& theirs : {toJson(base), std::string("no JSON"), mine}) {
        const auto both = mergedState(toJson(base), mine, theirs);
        ASSERT_TRUE(both);
        EXPECT_EQ(both->json, mine);
        EXPECT_FALSE(both->holdsMore);
    }
}

TEST(MergedState, HasWhatWasMeasuredInBoth) {
    const StudyState base = with({distance(10.0)});
    const StudyState both =
        merged(base, with({distance(10.0), distance(20.0)}), with({distance(10.0), distance(30.0)}), true);
    EXPECT_EQ(lengthsIn(both), (Lengths{10.0, 20.0, 30.0}));
    // Also from the same beginning, of which nothing was kept.
    EXPECT_EQ(lengthsIn(merged({}, with({distance(20.0)}), with({distance(30.0)}), true)),
              (Lengths{20.0, 30.0}));
    // The same, measured in both, is one.
    EXPECT_EQ(lengthsIn(merged({}, with({distance(20.0)}), with({distance(20.0)}))), (Lengths{20.0}));
}

TEST(MergedState, WhatOnePersonHasRemovedIsGoneAndWhatTheOtherHasChangedStays) {
    const StudyState base = with({distance(10.0), distance(20.0)});
    EXPECT_EQ(lengthsIn(merged(base, with({distance(20.0)}),
                               with({distance(10.0), distance(20.0), distance(30.0)}), true)),
              (Lengths{20.0, 30.0}));
    EXPECT_EQ(lengthsIn(merged(base, with({distance(10.0), distance(20.0), distance(40.0)}),
                               with({distance(20.0)}))),
              (Lengths{20.0, 40.0}));
    // Removed here, dragged there.
    EXPECT_EQ(lengthsIn(merged(base, with({distance(10.0)}), with({distance(10.0), distance(21.0)}), true)),
              (Lengths{10.0, 21.0}));
    // Dragged in both.
    EXPECT_EQ(lengthsIn(merged(base, with({distance(10.0), distance(22.0)}),
                               with({distance(10.0), distance(21.0)}), true)),
              (Lengths{10.0, 21.0, 22.0}));
    // Two that are equal are two.
    const StudyState twice = with({distance(10.0), distance(10.0)});
    EXPECT_EQ(lengthsIn(merged(twice, with({distance(10.0)}), twice)), (Lengths{10.0}));
}

TEST(MergedState, OfTheRestEachHasWhatItHasChangedAndTheOwnCountsWhereBothHave) {
    StudyState base;
    StudyState mine = base;
    mine.settings.look = trace::Look::mip;
    mine.slices.isInverted = true;
    StudyState theirs = base;
    theirs.settings.exposure = 2.0;
    theirs.slices.asAcquired = true;
    theirs.layout = Layout::axial;
    const StudyState both = merged(base, mine, theirs);
    EXPECT_EQ(both.settings.look, trace::Look::mip);
    EXPECT_EQ(both.settings.exposure, 2.0);
    EXPECT_EQ(both.layout, Layout::axial);
    EXPECT_TRUE(both.slices.isInverted);
    EXPECT_FALSE(both.slices.asAcquired) << "how slices are shown is one thing";
}

TEST(MergedState, MoreThanAStateMayHoldIsNoState) {
    std::vector<slices::Measurement> mine;
    std::vector<slices::Measurement> theirs;
    for (int i = 0; i < 600; ++i) {
        mine.push_back(distance(1.0 + i));
        theirs.push_back(distance(1001.0 + i));
    }
    EXPECT_FALSE(mergedState(toJson(StudyState{}), toJson(with(mine)), toJson(with(theirs))));
}

TEST(MergedState, HasTheOutlinesAndLesionsOfBoth) {
    const auto outline = [](double size) {
        return slices::Measurement{.shape = slices::Outline{{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}}};
    };
    const StudyState base = with({outline(1.0), distance(10.0)});
    const StudyState mine = with({outline(1.0), distance(10.0), outline(2.0)});
    const StudyState theirs = with({outline(3.0), outline(1.0), distance(10.0)});
    const StudyState both = merged(base, mine, theirs, true);
    EXPECT_EQ(both.measurements.size(), 4u);
    for (const double size : {1.0, 2.0, 3.0})
        EXPECT_EQ(std::ranges::count(both.measurements, outline(size)), 1) << size;
}

}  // namespace
}  // namespace macula::scene
