// The parts of macula-bench evaluate live-picture that need no device: what is made of a recording and of a
// series of pictures, and what is told of them.
#include "evaluate/live_picture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace macula::evaluate {
namespace {

using live::OnScreen;
using live::RecordingPhase;

// One a second, from 0 on.
std::vector<RestPicture> seriesOf(const std::vector<double>& flips) {
    std::vector<RestPicture> pictures;
    for (const double flip : flips) pictures.push_back({.atS = double(pictures.size()), .flip = flip});
    return pictures;
}

live::RecordedFrame frameAt(double atS, RecordingPhase phase, OnScreen picture) {
    live::RecordedFrame frame{.atS = atS, .phase = phase};
    frame.shown.picture = picture;
    return frame;
}

TEST(NearFrom, IsWhereThePictureComesNearForGood) {
    EXPECT_EQ(nearFromS(seriesOf({0.3, 0.1, 0.02, 0.01}), 0.02), 2.0) << "the limit itself is near";
    EXPECT_EQ(nearFromS(seriesOf({0.01, 0.0}), 0.02), 0.0) << "at once";
    EXPECT_EQ(nearFromS(seriesOf({0.3, 0.1}), 0.02), std::nullopt) << "never";
    EXPECT_EQ(nearFromS(seriesOf({0.1, 0.01, 0.03, 0.01}), 0.02), 3.0) << "the first time did not last";
    EXPECT_EQ(nearFromS(seriesOf({0.01, 0.01, 0.03}), 0.02), std::nullopt) << "it did not stay";
    EXPECT_EQ(nearFromS({}, 0.02), std::nullopt);
}

TEST(WorstSetback, IsBesideThePictureOfBefore) {
    EXPECT_DOUBLE_EQ(worstSetback(seriesOf({0.1, 0.2, 0.05, 0.25}), 2.0).value(), 0.05) << "0.25 - 0.2";
    EXPECT_DOUBLE_EQ(worstSetback(seriesOf({0.1, 0.2, 0.05, 0.25}), 1.0).value(), 0.2) << "0.25 - 0.05";
    EXPECT_DOUBLE_EQ(worstSetback(seriesOf({0.75, 0.5, 0.125}), 1.0).value(), -0.25) << "it fell all along";
    EXPECT_EQ(worstSetback(seriesOf({0.1, 0.9, 0.1}), 5.0), std::nullopt) << "all are younger";
    EXPECT_EQ(worstSetback({}, 5.0), std::nullopt);
    // The last picture that is old enough counts, however old that is.
    const std::vector<RestPicture> sparse{
        {.atS = 0.0, .flip = 0.5}, {.atS = 1.0, .flip = 0.25}, {.atS = 9.0, .flip = 0.375}};
    EXPECT_DOUBLE_EQ(worstSetback(sparse, 5.0).value(), 0.125);
}

TEST(WorstRise, IsAboveTheBestPictureOfBefore) {
    EXPECT_DOUBLE_EQ(worstRise(seriesOf({0.5, 0.25, 0.375, 0.3125})).value(), 0.125);
    EXPECT_DOUBLE_EQ(worstRise(seriesOf({0.5, 0.25, 0.375, 0.4375})).value(), 0.1875) << "by and by";
    EXPECT_DOUBLE_EQ(worstRise(seriesOf({0.75, 0.5, 0.375})).value(), -0.125) << "it fell all along";
    EXPECT_EQ(worstRise(seriesOf({0.5})), std::nullopt) << "it has replaced none";
    EXPECT_EQ(worstRise({}), std::nullopt);
}

TEST(FirstModel, CountsFromTheFirstPicture) {
    live::LiveRecording recording;
    EXPECT_EQ(firstModelS(recording), std::nullopt);
    recording.frames = {frameAt(2.0, RecordingPhase::opening, OnScreen::preview),
                        frameAt(3.0, RecordingPhase::opening, OnScreen::traced)};
    EXPECT_EQ(firstModelS(recording), std::nullopt);
    recording.frames.push_back(frameAt(5.0, RecordingPhase::moving, OnScreen::model));
    EXPECT_EQ(firstModelS(recording), std::nullopt) << "the camera had moved";
    recording.frames.insert(recording.frames.begin() + 1,
                            frameAt(2.5, RecordingPhase::opening, OnScreen::model));
    EXPECT_EQ(firstModelS(recording), 0.5);
}

// Changed at 10 s, ended at 20 s.
live::LiveRecording changedRecording(const std::vector<std::pair<double, OnScreen>>& shown) {
    live::LiveRecording recording;
    recording.inputs = {{.atS = 0.0, .phase = RecordingPhase::opening},
                        {.atS = 4.0, .phase = RecordingPhase::resting},
                        {.atS = 10.0, .phase = RecordingPhase::changed}};
    recording.frames = {frameAt(1.0, RecordingPhase::opening, OnScreen::traced),
                        frameAt(9.0, RecordingPhase::resting, OnScreen::traced)};
    for (const auto& [atS, picture] : shown)
        recording.frames.push_back(frameAt(atS, RecordingPhase::changed, picture));
    recording.seconds = 20.0;
    return recording;
}

TEST(ChangeTimes, AreSinceTheChange) {
    EXPECT_FALSE(changeTimes({}));
    const live::LiveRecording recording = changedRecording({{10.5, OnScreen::preview},
                                                            {12.0, OnScreen::preview},
                                                            {13.0, OnScreen::model},
                                                            {19.0, OnScreen::traced}});
    EXPECT_EQ(beginS(recording, RecordingPhase::resting), 4.0);
    EXPECT_EQ(beginS(recording, RecordingPhase::moving), std::nullopt);
    const auto times = changeTimes(recording);
    ASSERT_TRUE(times);
    EXPECT_EQ(times->firstNewS, 0.5);
    EXPECT_EQ(times->firstFullS, 3.0);
    EXPECT_EQ(times->longestStaleS, 1.5) << "what comes after the first with all pixels does not count";
    EXPECT_FALSE(times->wasSaid);
}

TEST(ChangeTimes, GoOnToTheEndWhereNoPictureComes) {
    const auto nothing = changeTimes(changedRecording({}));
    ASSERT_TRUE(nothing);
    EXPECT_EQ(nothing->firstNewS, std::nullopt);
    EXPECT_EQ(nothing->firstFullS, std::nullopt);
    EXPECT_EQ(nothing->longestStaleS, 10.0);
    const auto onlySmall = changeTimes(changedRecording({{13.0, OnScreen::preview}}));
    ASSERT_TRUE(onlySmall);
    EXPECT_EQ(onlySmall->firstNewS, 3.0);
    EXPECT_EQ(onlySmall->firstFullS, std::nullopt);
    EXPECT_EQ(onlySmall->longestStaleS, 7.0);
}

TEST(ChangeTimes, KnowWhetherItWasSaidSoon) {
    const auto wasSaid = [](double atS) {
        live::LiveRecording recording = changedRecording({{15.0, OnScreen::traced}});
        recording.notices = {{.atS = atS, .what = Text("Preparing the volume")}};
        return changeTimes(recording).value().wasSaid;
    };
    EXPECT_FALSE(wasSaid(9.0)) << "of what was before";
    EXPECT_TRUE(wasSaid(10.25));
    EXPECT_FALSE(wasSaid(10.5)) << "too late";
}

TEST(LivePictureReports, HoldEveryNumber) {
    LivePictureReport report{
        .motion = {.framesPerSecond = 8.0, .latencyMs = 120.0, .lateMs = 240.0, .frames = 9},
        .firstModelS = 4.5,
        .rest = {.pictures = seriesOf({0.5, 0.25, 0.01}), .referenceFlip = 0.005}};
    report.rest.pictures[1].picture = OnScreen::traced;
    report.rest.pictures[1].samplesPerPixel = 16;
    report.rest.pictures[1].maskedPsnrDb = 30.0;
    report.change = {.preset = "cinematic-bone",
                     .times = {.firstNewS = 0.5, .firstFullS = 2.0, .longestStaleS = 1.5, .wasSaid = true},
                     .rest = {}};
    const auto json = toJson(report);
    EXPECT_EQ(json["motion"]["framesPerSecond"], 8.0);
    EXPECT_EQ(json["motion"]["latencyMs"]["median"], 120.0);
    EXPECT_EQ(json["motion"]["latencyMs"]["p95"], 240.0);
    EXPECT_EQ(json["firstModelS"], 4.5);
    const auto& rest = json["rest"];
    EXPECT_EQ(rest["toFlip002S"], 2.0);
    EXPECT_EQ(rest["lastFlip"], 0.01);
    EXPECT_EQ(rest["referenceFlip"], 0.005);
    EXPECT_TRUE(rest["worstSetback"].is_null()) << "none is 5 s older";
    EXPECT_DOUBLE_EQ(rest["worstRise"].get<double>(), -0.24);
    ASSERT_EQ(rest["series"].size(), 3u);
    EXPECT_TRUE(rest["series"][0]["samplesPerPixel"].is_null());
    EXPECT_TRUE(rest["series"][0]["maskedPsnrDb"].is_null());
    EXPECT_EQ(rest["series"][1]["atS"], 1.0);
    EXPECT_EQ(rest["series"][1]["picture"], "traced");
    EXPECT_EQ(rest["series"][1]["samplesPerPixel"], 16);
    EXPECT_EQ(rest["series"][1]["flip"], 0.25);
    EXPECT_EQ(rest["series"][1]["maskedPsnrDb"], 30.0);
    const auto& change = json["change"];
    EXPECT_EQ(change["preset"], "cinematic-bone");
    EXPECT_EQ(change["firstNewS"], 0.5);
    EXPECT_EQ(change["firstFullS"], 2.0);
    EXPECT_EQ(change["stale"]["longestMs"], 1500.0);
    EXPECT_EQ(change["stale"]["wasSaid"], true);
    EXPECT_TRUE(change["rest"]["lastFlip"].is_null());
    EXPECT_EQ(change["rest"]["series"].size(), 0u);

    const auto nothing = toJson(LivePictureReport{});
    EXPECT_TRUE(nothing["motion"]["latencyMs"]["median"].is_null()) << "no frame followed the camera";
    EXPECT_TRUE(nothing["firstModelS"].is_null());
    EXPECT_TRUE(nothing["change"].is_null());
}

}  // namespace
}  // namespace macula::evaluate
