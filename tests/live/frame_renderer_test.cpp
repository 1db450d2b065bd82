// What becomes of a model when a picture fails, with a device and without a window.
#include "live/frame/frame_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <variant>
#include <vector>

#include "base/phantom.h"
#include "gpu/lose_device.h"
#include "live/dark_renderer.h"
#include "live/frame/fidelity.h"
#include "scene/choice/preset_choice.h"

namespace macula::live {
namespace {

// Before anything was traced or learnt, and with all pixels.
TEST_F(FrameRendererTest, WhatIsOpenedIsEstimatedFirst) {
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil([&] { return shown_.has_value(); }));
    EXPECT_EQ(shown_->picture, OnScreen::estimate);
    EXPECT_EQ(shown_->width, input_.width);
    EXPECT_EQ(news_.steps, 0u);
    EXPECT_EQ(fidelityOf(*shown_).because,
              (std::vector<Text>{Text("preview only"), Text("estimated from the values")}));
    ASSERT_TRUE(stepUntil([&] { return shown_->picture == OnScreen::traced; }));
}

TEST_F(FrameRendererTest, AnEditIsFollowedBeforeTheTracerHasAnyOfIt) {
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil(
        [&] { return hybrid::isFitToBeShown(news_) && shown_ && shown_->picture != OnScreen::estimate; }));
    const int before = preparing_;
    Clip clip;
    clip.planes = {{.normal = {0.0, 1.0, 0.0}, .offsetMm = 0.0}};
    const scene::Drawing learntOf = input_.drawing;
    for (int edit = 0; edit < 3; ++edit) {
        ++input_.sequence;
        clip.planes.front().offsetMm = 10.0 * edit;
        input_.drawing.clip = std::make_shared<const Clip>(clip);
        renderer_->accept(input_);
        // The next edit is there when this one was shown.
        renderer_->step({.newInput = [] { return true; }, .stopping = [] { return false; }});
        ASSERT_EQ(shown_->inputSequence, input_.sequence);
        EXPECT_EQ(shown_->picture, OnScreen::estimate);
        EXPECT_EQ(shown_->width, input_.width);
    }
    EXPECT_EQ(preparing_, before);
    // A hand that orbits, or a host that has time for a frame only, keeps no edit from the tracer.
    for (int move = 0; move < 10'000 && preparing_ == before; ++move) {
        ++input_.sequence;
        input_.camera.verticalFovDeg += 1e-3;
        renderer_->accept(input_);
        renderer_->step({.newInput = [] { return true; }, .stopping = [] { return false; }});
    }
    EXPECT_GT(preparing_, before);
    // The hand rests.
    EXPECT_TRUE(stepUntil([&] { return shown_->picture == OnScreen::traced; }));
    EXPECT_TRUE(failures_.empty());
    // Of what was learnt already there is more than an estimate.
    ++input_.sequence;
    input_.drawing = learntOf;
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil([&] { return shown_->inputSequence == input_.sequence; }));
    EXPECT_NE(shown_->picture, OnScreen::estimate);
    EXPECT_EQ(news_.origin, hybrid::ModelOrigin::shelf);
}

// As after a step that ran out of memory: what was learnt by then is not lost with the picture.
TEST_F(FrameRendererTest, AModelIsKeptWhenAPictureFails) {
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil([&] { return news_.stage == hybrid::ModelStage::learning; }));
    keeper_->kept_.clear();
    renderer_->fail([] {
        return Error{
            ErrorCode::outOfMemory, Text("There is not enough memory."), {}, Text("Close other programs.")};
    });
    EXPECT_EQ(failures_, std::vector<std::string>{"There is not enough memory."});
    ASSERT_EQ(keeper_->lookedFor_.size(), 1u);
    ASSERT_EQ(keeper_->kept_.size(), 1u);
    EXPECT_EQ(keeper_->kept_.front()->training.options.key, keeper_->lookedFor_.front());
    EXPECT_TRUE(keeper_->kept_.front()->validate().ok());

    // And it is gone on with.
    ++input_.sequence;
    input_.camera.verticalFovDeg = 24.0;
    renderer_->accept(input_);
    EXPECT_TRUE(stepUntil([&] { return news_.origin == hybrid::ModelOrigin::shelf; }));
    EXPECT_EQ(keeper_->lookedFor_.size(), 1u);
}

TEST_F(FrameRendererTest, TheModelIsGivenToWhoAsksAndOnlyThatOfWhatIsWanted) {
    input_.modelRequests = 1;
    renderer_->accept(input_);
    ASSERT_TRUE(taken_);
    EXPECT_EQ(taken_->request, 1u);
    EXPECT_FALSE(taken_->splats) << "there is none yet";
    ASSERT_TRUE(stepUntil([&] { return news_.stage == hybrid::ModelStage::learning; }));
    input_.modelRequests = 2;
    input_.requestsTraining = true;
    renderer_->accept(input_);
    ASSERT_EQ(taken_->request, 2u);
    ASSERT_TRUE(taken_->splats);
    EXPECT_TRUE(taken_->splats->validate().ok());
    EXPECT_GT(taken_->splats->size(), 0u);
    EXPECT_GT(taken_->gain, 0.0);
    ASSERT_TRUE(taken_->state);
    EXPECT_TRUE(taken_->state->validate().ok());
    // Other light: what is on the device is not of that.
    input_.drawing.settings.lightStrength = 2.0;
    input_.modelRequests = 3;
    renderer_->accept(input_);
    EXPECT_EQ(taken_->request, 3u);
    EXPECT_FALSE(taken_->splats);
}

// Whoever saves a model does not wait for ever.
TEST_F(FrameRendererTest, AModelThatCannotBeReadIsAnsweredWithTheError) {
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil([&] { return news_.stage == hybrid::ModelStage::learning; }));
    macula::test::loseDeviceAt(macula::test::VulkanCall::wait, 1);
    input_.modelRequests = 1;
    input_.requestsTraining = true;
    renderer_->accept(input_);
    macula::test::loseDeviceAt(macula::test::VulkanCall::wait, 1, 0);
    ASSERT_TRUE(taken_);
    EXPECT_EQ(taken_->request, 1u);
    ASSERT_TRUE(taken_->error);
    EXPECT_FALSE(taken_->error->message.empty());
    EXPECT_FALSE(taken_->splats);
    EXPECT_FALSE(taken_->state);
}

// A picture that is final goes on where less noise is wanted, and keeps its samples.
TEST_F(FrameRendererTest, LessNoiseIsTracedOnTopOfWhatThereIs) {
    input_.usesModel = false;
    input_.sampleLimit = 8;
    renderer_->accept(input_);
    const auto isFinal = [&] { return shown_ && shown_->stage == Stage::converged; };
    ASSERT_TRUE(stepUntil(isFinal));
    const std::uint64_t before = shown_->samplesPerPixel;
    EXPECT_GE(before, 8u);
    EXPECT_EQ(shown_->noiseTarget, kUnseenNoise);
    shown_.reset();
    ++input_.sequence;
    input_.sampleLimit = 64;
    input_.noiseTarget = 1e-6;
    input_.convergesNow = true;
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil([&] { return shown_.has_value(); }));
    EXPECT_EQ(shown_->noiseTarget, 1e-6);
    EXPECT_GE(shown_->samplesPerPixel, before) << "it did not begin anew";
    ASSERT_TRUE(stepUntil(isFinal));
    EXPECT_GE(shown_->samplesPerPixel, 64u);
    EXPECT_GT(shown_->noise, 0.0);
}

// However many samples that takes. What was estimated of the opened study is weighed as a model is.
TEST_F(FrameRendererTest, FilterAndSplatsStayUntilNoiseCannotBeSeen) {
    input_.width = 24;
    input_.height = 18;
    input_.sampleLimit = 1'000'000;
    input_.convergesNow = true;
    renderer_->accept(input_);
    std::uint64_t most = 0;
    ASSERT_TRUE(stepUntil([&] {
        if (!shown_ || shown_->picture != OnScreen::traced) return false;
        if (shown_->stage == Stage::converged) return true;
        EXPECT_TRUE(shown_->denoised) << shown_->samplesPerPixel;
        EXPECT_TRUE(shown_->mixesModel) << shown_->samplesPerPixel;
        most = std::max(most, shown_->samplesPerPixel);
        return testing::Test::HasFailure();
    }));
    EXPECT_GT(most, 64u);
    EXPECT_LE(shown_->noise, kUnseenNoise);
    EXPECT_FALSE(shown_->denoised);
    EXPECT_FALSE(shown_->mixesModel);
    EXPECT_TRUE(fidelityOf(*shown_).isFinal);
    EXPECT_TRUE(fidelityOf(*shown_).because.empty());
}

// Nothing is prepared for another colour or opacity of a segment, and what a view is framed around stays.
TEST_F(FrameRendererTest, OtherColoursOfSegmentsPrepareNothing) {
    auto box = std::make_shared<TintBox>();
    box->volumeSize = input_.volume->size();
    box->size = box->volumeSize;
    box->voxels.assign(input_.volume->voxelCount(), 1);
    Additions added;
    added.tints = SegmentTints{box, {{.rgb = {1.0f, 0.0f, 0.0f}, .opacity = 1.0f}}};
    input_.usesModel = false;
    input_.drawing.additions = std::make_shared<const Additions>(added);
    const auto isFinal = [&] { return shown_ && shown_->stage == Stage::converged; };
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil(isFinal));
    const int preparing = preparing_;
    EXPECT_EQ(outlines_, 1);
    for (const float opacity : {0.7f, 0.3f}) {
        added.tints->colours.front().opacity = opacity;
        input_.drawing.additions = std::make_shared<const Additions>(added);
        ++input_.sequence;
        shown_.reset();
        renderer_->accept(input_);
        ASSERT_TRUE(stepUntil(isFinal));
    }
    EXPECT_EQ(preparing_, preparing);
    EXPECT_EQ(outlines_, 1);
    added.second.emplace();
    added.second->volume = input_.volume;
    added.second->function = input_.drawing.transferFunction;
    input_.drawing.additions = std::make_shared<const Additions>(added);
    ++input_.sequence;
    shown_.reset();
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil(isFinal));
    EXPECT_EQ(outlines_, 2) << "a second volume may reach further";
    EXPECT_TRUE(failures_.empty()) << failures_.front();
}

}  // namespace
}  // namespace macula::live
