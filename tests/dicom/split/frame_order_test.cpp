// What orders frames: times with offsets, without dates, across midnight; places that drift; ranks.
#include "dicom/split/frame_order.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dicom/read/date_time.h"
#include "dicom/split/phases.h"
#include "dicom/split/rank_model.h"
#include "frames_by_hand.h"

namespace macula::dicom {
namespace {

using namespace test;
using Values = std::vector<std::optional<double>>;

Values timesOf(const std::vector<std::string>& texts) {
    Frames made;
    for (std::size_t n = 0; n < texts.size(); ++n) {
        made.add(double(n));
        made.set("AcquisitionTime", texts[n]);
    }
    return orderValues(made.frames, splitRules(), attribute("AcquisitionTime"));
}

TEST(Moment, HasAnOffsetADateAndATimeOfDay) {
    EXPECT_DOUBLE_EQ(momentOf("193059.25")->seconds, 70259.25);
    EXPECT_FALSE(momentOf("193059.25")->day);
    EXPECT_DOUBLE_EQ(momentOf("19700102000001")->seconds, 86401.0);
    EXPECT_EQ(momentOf("19700102000001")->day, 1);
    EXPECT_DOUBLE_EQ(momentOf("19700102030000+0200")->seconds, 86400.0 + 3600.0);
    EXPECT_DOUBLE_EQ(momentOf("19700101220000-0330")->seconds, 86400.0 + 5400.0);
    EXPECT_DOUBLE_EQ(momentOf("030000+0200")->seconds, 3600.0);
    for (const char* none : {"", "20200101", "20200101+0100", "noon", "20201341120000", "99"})
        EXPECT_FALSE(momentOf(none)) << none;
    EXPECT_EQ(secondsOfOffset("+0100"), 3600.0);
    EXPECT_EQ(secondsOfOffset("-0330"), -12600.0);
    for (const char* none : {"", "0100", "+1", "+01:00", "+01x0"})
        EXPECT_FALSE(secondsOfOffset(none)) << none;
}

TEST(OrderValues, RunAcrossMidnightWithoutADateOrOnOneDay) {
    for (const std::string day : {"", "20200101"}) {
        const Values values = timesOf({day + "235930", day + "000010", day + "000050"});
        EXPECT_DOUBLE_EQ(*values[1] - *values[0], 40.0);
        EXPECT_DOUBLE_EQ(*values[2] - *values[1], 40.0);
    }
    // Eleven hours are a long day, and no midnight.
    const Values values = timesOf({"080000", "190000"});
    EXPECT_DOUBLE_EQ(*values[1] - *values[0], 39600.0);
}

TEST(OrderValues, ThatCannotBeComparedAreNone) {
    for (const auto& value : timesOf({"20200101100000", "100001"})) EXPECT_FALSE(value);
    const Values some = timesOf({"100000", "", "100002"});
    EXPECT_TRUE(some[0] && !some[1] && some[2]);
}

TEST(PlaceTolerance, IsThatOfADriftAndOfNothingElse) {
    const auto toleranceOf = [](const std::vector<double>& alongMm) {
        Frames made;
        for (const double z : alongMm) made.add(z);
        return placeToleranceMm(made.frames);
    };
    EXPECT_EQ(toleranceOf({0, 1, 2, 3, 4, 5}), kSamePositionMm);
    EXPECT_EQ(toleranceOf({0, 0, 1, 1, 2, 2}), kSamePositionMm);
    const double drift = toleranceOf({0, 0.004, 1, 1.004, 2, 2.004});
    EXPECT_GE(drift, 0.004);
    EXPECT_LT(drift, 0.1);
    // Two body regions, a gap, and acquisitions a third of a step apart are no drift.
    EXPECT_EQ(toleranceOf({0, 1, 2, 3, 400, 401, 402, 403}), kSamePositionMm);
    EXPECT_EQ(toleranceOf({0, 1, 2, 3, 30, 31}), kSamePositionMm);
    EXPECT_EQ(toleranceOf({0, 0.3, 1, 1.3, 2, 2.3}), kSamePositionMm);
    EXPECT_EQ(toleranceOf({}), kSamePositionMm);
    EXPECT_EQ(toleranceOf({7}), kSamePositionMm);
}

// `values` phase by phase at the same places.
std::optional<Phases> ranked(const std::vector<Values>& phases, bool numbered = true) {
    Frames made;
    Values all;
    for (const Values& values : phases) {
        for (std::size_t k = 0; k < values.size(); ++k) {
            made.add(2.0 * double(k));
            if (!numbered) made.instance().instanceNumber.reset();
            all.push_back(values[k]);
        }
    }
    return phasesByRank(made.frames, all);
}

TEST(PhasesByRank, CountOnlyWhereTheOrderIsTheSameAlongTheStack) {
    const auto good = ranked({{0, 1, 2, 3, 4, 5, 6, 7}, {30, 31, 32, 33, 34, 35, 36, 37}});
    ASSERT_TRUE(good);
    EXPECT_EQ(good->parts[0].frames, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_TRUE(good->unclear.empty() && good->byNumber.empty());
    EXPECT_FALSE(ranked({{0, 90, 2, 55, 14, 5, 61, 7}, {30, 3, 72, 38, 3, 35, 9, 70}}, false));
}

// Two phases: the image of the first at place 3 comes as much after the second one as that after it, so that
// the distances are the usual ones, and only what is beside it tells.
TEST(PhasesByRank, ASwapThatLooksLikeTheUsualDistanceIsSeen) {
    for (const bool numbered : {false, true}) {
        const auto phases = ranked({{0, 1, 2, 63, 4, 5, 6, 7}, {30, 31, 32, 33, 34, 35, 36, 37}}, numbered);
        ASSERT_TRUE(phases);
        if (numbered) {
            EXPECT_EQ(phases->byNumber, (std::vector<std::size_t>{3}));
            EXPECT_EQ(phases->parts[0].frames, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7}));
        } else {
            EXPECT_EQ(phases->unclear, (std::vector<std::size_t>{3}));
            EXPECT_EQ(phases->parts[0].frames, (std::vector<std::size_t>{0, 1, 2, 4, 5, 6, 7}));
        }
        EXPECT_EQ(phases->parts[1].frames, (std::vector<std::size_t>{8, 9, 10, 11, 12, 13, 14, 15}));
    }
}

TEST(PhasesByRank, OfExtremeValuesAreRightOrNone) {
    const double inf = std::numeric_limits<double>::infinity();
    const double denormal = std::numeric_limits<double>::denorm_min();
    EXPECT_FALSE(ranked({}));
    EXPECT_FALSE(ranked({{0}, {1}}));
    EXPECT_FALSE(ranked({{0, 0, 0, 0}, {0, 0, 0, 0}}));
    EXPECT_FALSE(ranked({{{}, {}, {}, {}}, {{}, {}, {}, {}}}, false));
    EXPECT_FALSE(ranked({{0, 0, 0, 0}, {inf, inf, inf, inf}}, false));
    // Distances of a million to one, and of the smallest numbers there are.
    const auto wide = ranked({{0, 0, 0, 0}, {1, 1, 1, 1}, {1e6, 1e6, 1e6, 1e6}});
    ASSERT_TRUE(wide);
    EXPECT_EQ(wide->parts[1].frames, (std::vector<std::size_t>{4, 5, 6, 7}));
    const auto tiny = ranked({{0, 0, 0, 0}, {denormal, denormal, denormal, denormal}});
    if (tiny) {
        EXPECT_EQ(tiny->parts[0].frames, (std::vector<std::size_t>{0, 1, 2, 3}));
    }
}

}  // namespace
}  // namespace macula::dicom
