// The parts of macula-bench session that need no device.
#include "evaluate/store_round_trip.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numeric>

namespace macula::evaluate {
namespace {

TEST(FrameTimes, AreInTheFirstBucketWhoseEdgeTheyDoNotExceed) {
    const FrameTimes times{.ms = {0.0, 5.0, 5.1, 1000.0, 1000.1, 4.0}};
    const auto frames = times.histogram();
    EXPECT_EQ(frames.front(), 3u);
    EXPECT_EQ(frames[1], 1u);
    EXPECT_EQ(frames[kFrameBucketsMs.size() - 1], 1u);
    EXPECT_EQ(frames.back(), 1u);
    EXPECT_EQ(std::accumulate(frames.begin(), frames.end(), std::size_t(0)), times.ms.size());
    EXPECT_EQ(times.maxMs(), 1000.1);
    EXPECT_DOUBLE_EQ(times.percentileMs(0.5), 5.05);
}

TEST(SessionReport, TellsByHowMuchSavingDelaysAFrame) {
    StoreRoundTrip measured;
    measured.saving.without.ms = {10.0, 20.0, 30.0};
    measured.saving.beside.ms = {11.0, 24.0, 50.0};
    measured.saving.callsMs = {1.0, 7.0, 2.0};
    const auto json = toJson(measured)["saving"];
    EXPECT_DOUBLE_EQ(json["slowerMedianMs"], 4.0);
    EXPECT_DOUBLE_EQ(json["slowerP95Ms"], 47.4 - 29.0);
    EXPECT_EQ(json["callMedianMs"], 2.0);
    EXPECT_EQ(json["callMaxMs"], 7.0);
    EXPECT_TRUE(json["framesWithout"]["histogram"].back()["atMostMs"].is_null());
}

TEST(SessionReport, HoldsTheErrorAfterReopeningToThatBefore) {
    StoreRoundTrip measured;
    measured.learnt.shownError = 0.25;
    measured.reopenings = {{.shownError = 0.375, .isSame = false}, {.isKeeperReady = true, .isSame = true}};
    const auto json = toJson(measured);
    EXPECT_EQ(json["reopenings"][0]["shownErrorDifference"], 0.125);
    EXPECT_EQ(json["reopenings"][0]["sameToTheBit"], false);
    EXPECT_TRUE(json["reopenings"][1]["shownErrorDifference"].is_null()) << "nothing was held out";
    EXPECT_EQ(json["reopenings"][1]["sameToTheBit"], true);
    EXPECT_FALSE(json.contains("store"));
    EXPECT_TRUE(json["saving"]["slowerMedianMs"].is_null()) << "no frames, no number";
    measured.store = StoreBenchmark{.capBytes = 5, .bytesLeft = 6};
    EXPECT_EQ(toJson(measured)["store"]["capHolds"], false);
}

}  // namespace
}  // namespace macula::evaluate
