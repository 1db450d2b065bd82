#include "live/frame/fidelity.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace macula::live {
namespace {

using Because = std::vector<std::string>;

Because because(const FrameShown& frame) {
    Because english;
    for (const Text& reason : fidelityOf(frame).because) english.push_back(reason.english());
    return english;
}

TEST(Fidelity, OfATracedPictureWithAllItsSamplesIsFinalWithoutReserve) {
    const FrameShown frame{
        .picture = OnScreen::traced, .stage = Stage::converged, .samplesPerPixel = 64, .sampleLimit = 64};
    const Fidelity fidelity = fidelityOf(frame);
    EXPECT_TRUE(fidelity.isFinal);
    EXPECT_EQ(because(frame), Because{});
    EXPECT_EQ(toJson(frame)["fidelity"], "final");
    EXPECT_EQ(toJson(frame)["tracedShare"], 1.0);
}

TEST(Fidelity, SaysWhyAPictureInMotionIsNoModel) {
    FrameShown frame{.picture = OnScreen::preview, .stage = Stage::converged};
    EXPECT_EQ(because(frame), Because{});
    frame.camera.parallelHeightMm = 200;
    EXPECT_EQ(because(frame), Because{}) << "parallel rays are no reason";
}

TEST(Fidelity, SaysWhyASmallPictureStandsWhereAModelIs) {
    FrameShown frame{.picture = OnScreen::preview, .stage = Stage::converged};
    frame.model = {.stage = hybrid::ModelStage::learning, .steps = 56};
    EXPECT_EQ(because(frame), Because{"the preview is not sharp enough after 56 steps"});
    frame.model.isSharp = true;
    EXPECT_EQ(because(frame), Because{}) << "it is shown next";
    frame.model = {.stage = hybrid::ModelStage::resting, .steps = 56};
    EXPECT_EQ(because(frame), Because{"the preview is not sharp enough after 56 steps"});
    frame.model = {.stage = hybrid::ModelStage::noRoom, .steps = 56};
    EXPECT_EQ(because(frame), Because{}) << "it will never be shown";
    frame.picture = OnScreen::traced;
    frame.model.stage = hybrid::ModelStage::learning;
    EXPECT_EQ(because(frame), Because{}) << "a traced picture is what it is";
}

TEST(Fidelity, OfAModelIsOneFact) {
    using hybrid::ModelStage;
    for (const auto stage : {ModelStage::none, ModelStage::searching, ModelStage::nothingToSee,
                             ModelStage::noRoom, ModelStage::failed})
        EXPECT_FALSE(hybrid::isFitToBeShown({.stage = stage, .isSharp = true})) << nameOf(stage);
    for (const auto stage : {ModelStage::resuming, ModelStage::learning, ModelStage::resting}) {
        EXPECT_FALSE(hybrid::isFitToBeShown({.stage = stage, .steps = 10'000})) << nameOf(stage);
        EXPECT_TRUE(hybrid::isFitToBeShown({.stage = stage, .steps = 1, .isSharp = true})) << nameOf(stage);
    }
}

TEST(Fidelity, SaysWhatIsBetweenAFrameAndTheTruth) {
    FrameShown frame{.picture = OnScreen::model};
    EXPECT_FALSE(fidelityOf(frame).isFinal);
    EXPECT_EQ(because(frame), Because{"preview only"});
    EXPECT_EQ(toJson(frame)["tracedShare"], 0.0);
    EXPECT_FALSE(toJson(frame).contains("fovea"));
    frame.picture = OnScreen::estimate;
    EXPECT_EQ(because(frame), (Because{"preview only", "estimated from the values"}));
    EXPECT_EQ(toJson(frame)["picture"], "estimate");
    EXPECT_EQ(toJson(frame)["tracedShare"], 0.0);
    frame.picture = OnScreen::model;

    frame.foveaAgeMs = 340.0;
    frame.foveaSamples = 2;
    frame.foveaShare = 0.25;
    frame.greyFacesAreCoarse = true;
    EXPECT_EQ(because(frame),
              (Because{"preview around the sharp centre", "sharp centre traced 0.3 s ago with 2 samples",
                       "values on cut faces only coarsely"}));
    EXPECT_EQ(toJson(frame)["tracedShare"], 0.25);
    EXPECT_EQ(toJson(frame)["fovea"]["ageMs"], 340.0);

    const FrameShown small{.picture = OnScreen::preview,
                           .stage = Stage::moving,
                           .scale = 4,
                           .samplesPerPixel = 1,
                           .sampleLimit = 512,
                           .denoised = true};
    EXPECT_EQ(because(small), (Because{"1/4 of the pixels each way", "1 of 512 samples", "denoised"}));

    const FrameShown done{
        .picture = OnScreen::traced, .stage = Stage::converged, .denoised = true, .samplesLeftOut = 3};
    EXPECT_TRUE(fidelityOf(done).isFinal);
    EXPECT_EQ(because(done), (Because{"denoised", "3 samples left out"}));

    FrameShown coarse{.picture = OnScreen::traced, .stage = Stage::converged};
    coarse.messages.emplace_back();
    EXPECT_EQ(because(coarse), Because{"less than the full resolution"});

    const FrameShown fading{
        .picture = OnScreen::fading, .stage = Stage::converging, .samplesPerPixel = 2, .sampleLimit = 512};
    EXPECT_FALSE(fidelityOf(fading).isFinal);
    EXPECT_EQ(because(fading), (Because{"preview fades out", "2 of 512 samples"}));

    FrameShown mixed = fading;
    mixed.picture = OnScreen::traced;
    mixed.mixesModel = true;
    EXPECT_EQ(because(mixed), (Because{"preview where it is less noisy", "2 of 512 samples"}));
}

}  // namespace
}  // namespace macula::live
