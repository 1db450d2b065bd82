// How a model goes on from what was kept of it, and when the device fails.
#include <algorithm>
#include <sstream>

#include "gpu/lose_device.h"
#include "hybrid/model/peripheral_scene.h"
#include "pipeline/splat/files/training_file.h"

namespace macula::hybrid {
namespace {

using splat::testing::sameBits;
using test::VulkanCall;

class PeripheralResume : public PeripheralTest {
  protected:
    void TearDown() override {
        test::loseDeviceAt(VulkanCall::submit, 1, 0);
        PeripheralTest::TearDown();
    }
};

TEST_F(PeripheralResume, WithoutRoomForMoreSplatsItGoesOnWithThoseItHas) {
    PeripheralOptions o = options();
    o.firstSteps = 10;
    o.splatsGrow = 1e6;
    o.mostSplats = 60000000;
    PeripheralModel model = begun(o);
    giveWanted(model, truth(), 5);
    ASSERT_TRUE(model.step(1e6, [&] { return model.report().training.steps < 10; }).ok());
    giveWanted(model, truth(), 3);
    ASSERT_TRUE(model.step(1e6, [&] { return model.report().training.steps < 13; }).ok());
    EXPECT_TRUE(model.report().noRoom);
    EXPECT_FALSE(model.isPaused());
    EXPECT_EQ(model.report().training.splats, 60u);
    EXPECT_GT(model.report().training.steps, 10u);
    // The round begins all the same: rates are warm again.
    EXPECT_EQ(model.report().rounds, 2u);
    const splat::TrainerOptions round = model.lastGood().training.options;
    EXPECT_EQ(round.optimizer.positionSteps, 10u + o.roundSteps);
    EXPECT_EQ(round.capacity, 60u);
    run(model);
    EXPECT_TRUE(model.report().noRoom) << "that it has settled since makes no room";
    EXPECT_EQ(model.report().rounds, 2u);
}

// Lost while it learns, judges, copies or is offered something: what is shown stays, and another device goes
// on as if nothing had happened.
TEST_F(PeripheralResume, AnotherDeviceGoesOnWhereOneWasLost) {
    int losses = 0;
    for (const auto& [call, nth] : {std::pair(VulkanCall::submit, 60), std::pair(VulkanCall::wait, 30)}) {
        const auto doomed = *gpu::Device::create(instance());
        PeripheralModel model = std::move(PeripheralModel::begin(doomed, start(), neverPaused())).value();
        giveWanted(model, truth(), 6);
        const auto shown = model.shown().splats;
        test::loseDeviceAt(call, nth);
        Result<void> done;
        for (int i = 0; i < 100 && done.ok(); ++i) done = model.step(20.0);
        ASSERT_EQ(test::devicesLost(), 1);
        ++losses;
        EXPECT_EQ(done.error().code, ErrorCode::deviceLost);
        EXPECT_TRUE(model.shown().splats->validate().ok());
        EXPECT_EQ(model.step(1.0).error().code, ErrorCode::deviceLost);
        EXPECT_EQ(model.wantedView().error().code, ErrorCode::deviceLost);
        EXPECT_EQ(model.offer(picture(truth(), cameraAt(11.0))).error().code, ErrorCode::deviceLost);
        const PeripheralState left = model.lastGood();
        EXPECT_EQ(left.heldOut.size(), 2u);
        EXPECT_EQ(left.training.views.size(), 4u);
        auto resumed = PeripheralModel::resume(device(), left, neverPaused());
        ASSERT_TRUE(resumed.ok());
        EXPECT_EQ(resumed->report().heldOut, 2u);
        EXPECT_TRUE(sameBits(*resumed->shown().splats, *model.shown().splats));
        EXPECT_GT(resumed->shown().generation, model.shown().generation);
        EXPECT_FALSE(resumed->isPaused());
        learn(*resumed, 150);
        EXPECT_GT(psnrOf(*resumed->shown().splats), psnrOf(TrainingTest::start()) + 3.0);
    }
    EXPECT_EQ(losses, 2);
}

// Of what a file holds: pictures are held out anew, and are others than it has learnt.
TEST_F(PeripheralResume, GoesOnFromAFile) {
    PeripheralModel model = begun(neverPaused());
    giveWanted(model, truth(), 6);
    ASSERT_TRUE(model.step(20.0).ok());
    std::stringstream file;
    splat::TrainingState saved = model.state()->training;
    saved.options.stages.push_back({.firstStep = 1, .measure = splat::LossMeasure::squared});
    ASSERT_TRUE(splat::writeTraining(file, saved).ok());
    auto read = splat::readTraining(file, file.str().size());
    ASSERT_TRUE(read.ok());
    auto resumed = PeripheralModel::resume(device(), {.training = std::move(read).value(), .seenMm = box()},
                                           neverPaused());
    ASSERT_TRUE(resumed.ok());
    EXPECT_TRUE(isComparedAsJudged(*resumed)) << "as macula train ends";
    EXPECT_EQ(resumed->report().views, 4u);
    EXPECT_EQ(resumed->report().heldOut, 0u);
    EXPECT_EQ(*resumed->offer(picture(truth(), cameraAt(0.0))), Offered::heldOut);
    giveWanted(*resumed, truth(), 4);
    EXPECT_EQ(resumed->report().heldOut, 2u);
    learn(*resumed, 150);
    EXPECT_GT(psnrOf(*resumed->shown().splats), psnrOf(TrainingTest::start()) + 3.0);
}

}  // namespace
}  // namespace macula::hybrid
