// What becomes of a model when what is shown is changed, and when the device fails.
#include <algorithm>
#include <sstream>

#include "gpu/lose_device.h"
#include "hybrid/model/peripheral_scene.h"
#include "pipeline/splat/files/training_file.h"

namespace macula::hybrid {
namespace {

using splat::testing::sameBits;
using test::VulkanCall;

class PeripheralChange : public PeripheralTest {
  protected:
    void TearDown() override {
        test::loseDeviceAt(VulkanCall::submit, 1, 0);
        PeripheralTest::TearDown();
    }

    // Half of it, in other colours.
    static splat::Splats changed() {
        splat::Splats splats = truth();
        for (std::size_t i = 0; i < splats.size(); ++i) {
            std::swap(splats.dc[i].x, splats.dc[i].z);
            if (splats.position[i].z > 0.0f) splats.opacityLogit[i] = -10.0f;
        }
        return splats;
    }
    static ModelStart changedStart(const std::string& key = "two") {
        ModelStart start{.splats = changed(), .seenMm = box(), .key = key};
        for (glm::vec3& dc : start.splats.dc) dc = glm::vec3(1.0f);
        return start;
    }
};

TEST_F(PeripheralChange, ShowsWhatWasUntilTheNewModelIsBetter) {
    PeripheralModel model = begun(neverPaused());
    giveWanted(model, truth(), 6);
    learn(model, 150);
    const ShownModel before = model.shown();
    const std::uint64_t stepsBefore = model.report().training.steps;

    // Warm: as good as before, so nothing is gained by showing it yet.
    ModelStart warm = changedStart();
    warm.splats = {};
    ASSERT_TRUE(model.change(warm).ok());
    EXPECT_EQ(model.report().pause, Pause::noViews);
    EXPECT_EQ(model.shown().generation, before.generation);
    EXPECT_TRUE(model.shown().isOfBefore);
    EXPECT_EQ(model.report().training.steps, 0u);
    EXPECT_TRUE(sameBits(model.state()->training.splats, *before.splats));
    for (int i = 0; i < 3; ++i) giveWanted(model, changed(), 1);
    EXPECT_TRUE(model.shown().isOfBefore);
    EXPECT_EQ(model.report().heldOut, 1u);
    for (int i = 0; i < 4; ++i) ASSERT_TRUE(model.step(5.0).ok());
    EXPECT_TRUE(model.shown().isOfBefore) << "one picture judges nothing";
    EXPECT_EQ(model.shown().splats, before.splats);
    giveWanted(model, changed(), 3);
    learn(model, 150);
    EXPECT_FALSE(model.shown().isOfBefore);
    EXPECT_GT(model.shown().generation, before.generation);
    EXPECT_LT(*model.report().shownError, 0.5);
    const double after = psnrFrom(*model.shown().splats, changed(), cameraAt(36.0, 20.0));
    EXPECT_GT(after, psnrFrom(*before.splats, changed(), cameraAt(36.0, 20.0)) + 3.0);

    // Back to what it knows, on another device if need be: at once, and with all that it had learnt.
    const std::uint64_t last = model.shown().generation;
    model = std::move(PeripheralModel::resume(device(), model.lastGood(), neverPaused())).value();
    EXPECT_FALSE(model.shown().isOfBefore);
    EXPECT_GT(model.shown().generation, last) << "not of the same splats";
    const std::uint64_t generation = model.shown().generation;
    ModelStart back = start();
    back.splats = {};
    ASSERT_TRUE(model.change(back).ok());
    EXPECT_FALSE(model.shown().isOfBefore);
    EXPECT_GT(model.shown().generation, generation);
    EXPECT_EQ(model.report().training.steps, stepsBefore);
    EXPECT_EQ(model.report().heldOut, 2u);
    EXPECT_GT(psnrOf(*model.shown().splats), psnrOf(TrainingTest::start()) + 3.0);
    // The same again is no change.
    ASSERT_TRUE(model.change(back).ok());
    EXPECT_EQ(model.report().training.steps, stepsBefore);
}

TEST_F(PeripheralChange, AStartThatIsBetterIsShownAsSoonAsTwoPicturesSaySo) {
    PeripheralModel model = begun(neverPaused());
    giveWanted(model, truth(), 5);
    ASSERT_TRUE(model.step(30.0).ok());
    const std::uint64_t generation = model.shown().generation;
    ASSERT_TRUE(model.change(changedStart()).ok());
    giveWanted(model, changed(), 3);
    EXPECT_TRUE(model.shown().isOfBefore);
    giveWanted(model, changed(), 1);  // the second that is held out
    EXPECT_EQ(model.report().heldOut, 2u);
    EXPECT_FALSE(model.shown().isOfBefore);
    EXPECT_EQ(model.shown().generation, generation + 1);
    EXPECT_TRUE(sameBits(*model.shown().splats, withDirections(changedStart().splats)));

    // What cannot be begun changes nothing.
    const auto shown = model.shown().splats;
    ModelStart none = changedStart("three");
    none.seenMm = {};
    EXPECT_EQ(model.change(none).error().code, ErrorCode::usage);
    ModelStart tooLarge = changedStart("three");
    tooLarge.splats.resize(3000000);
    {
        const test::NoMemory full(100'000'000);  // a large card has room for it
        const Result<void> change = model.change(tooLarge);
        ASSERT_FALSE(change.ok());
        EXPECT_EQ(change.error().code, ErrorCode::outOfMemory);
    }
    EXPECT_EQ(model.shown().splats, shown);
    EXPECT_EQ(model.report().views, 2u);
    EXPECT_TRUE(model.step(5.0).ok());
}

// There and back before anything of the other was shown: what is shown is of this, and nothing is waited for.
TEST_F(PeripheralChange, BackBeforeAnythingElseWasShownIsNoChangeOfWhatIsShown) {
    for (const std::uint64_t shelfBytes : {std::uint64_t(1) << 30, std::uint64_t(0)}) {
        PeripheralOptions o = neverPaused();
        o.shelfBytes = shelfBytes;
        PeripheralModel model = begun(o);
        giveWanted(model, truth(), 6);
        learn(model, 60);
        const ShownModel shown = model.shown();
        const PeripheralReport before = model.report();
        ASSERT_TRUE(model.change(changedStart()).ok());
        EXPECT_TRUE(model.shown().isOfBefore);
        ASSERT_TRUE(model.change(changedStart("three")).ok());
        EXPECT_TRUE(model.shown().isOfBefore);
        ASSERT_TRUE(model.change(start()).ok());
        EXPECT_FALSE(model.shown().isOfBefore);
        EXPECT_EQ(model.shown().splats, shown.splats);
        EXPECT_EQ(model.shown().generation, shown.generation);
        if (shelfBytes > 0) {
            EXPECT_EQ(model.report().training.steps, before.training.steps);
            EXPECT_EQ(model.report().heldOut, 2u);
            EXPECT_NEAR(*model.report().shownError, *before.shownError, 1e-4 * *before.shownError);
        } else {
            EXPECT_TRUE(sameBits(model.state()->training.splats, *shown.splats)) << "nothing is given up";
            giveWanted(model, truth(), 6);
        }
        learn(model, 150);
        EXPECT_GT(model.shown().generation, shown.generation);
        EXPECT_GT(psnrOf(*model.shown().splats), psnrOf(TrainingTest::start()) + 3.0);
    }
    // And on another device in between.
    PeripheralModel model = begun(neverPaused());
    ASSERT_TRUE(model.change(changedStart()).ok());
    model = std::move(PeripheralModel::resume(device(), model.lastGood(), neverPaused())).value();
    EXPECT_TRUE(model.shown().isOfBefore);
    ASSERT_TRUE(model.change(start()).ok());
    EXPECT_FALSE(model.shown().isOfBefore);
}

TEST_F(PeripheralChange, WithoutRoomForMoreSplatsItGoesOnWithThoseItHas) {
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

// A card that holds one model and its pictures, and not those of two.
TEST_F(PeripheralChange, GoesBackToAPresetOnAFullCard) {
    PeripheralModel model = begun(neverPaused());
    const auto learnFrom = [&](const splat::Splats& of) {
        for (int i = 0; i < 9; ++i)
            ASSERT_TRUE(model.offer(picture(of, cameraAt(40.0 * i, 30.0 * (i % 3)), {400, 320})).ok());
        learn(model, 12);
    };
    learnFrom(truth());
    const std::uint64_t steps = model.report().training.steps;
    ASSERT_TRUE(model.change(changedStart()).ok());
    learnFrom(changed());
    const auto before = model.shown().generation;
    ModelStart back = start();
    back.splats = {};
    {
        const test::NoMemory full;
        EXPECT_EQ(model.change(back).error().code, ErrorCode::outOfMemory);
    }
    // As before: with all its pictures.
    EXPECT_EQ(model.lastGood().training.options.key, "two");
    EXPECT_EQ(model.shown().generation, before);
    const std::uint64_t onward = model.report().training.steps;
    learn(model, 12);
    EXPECT_GE(model.report().training.steps, onward + 12);

    ASSERT_TRUE(device()->waitForAll().ok());
    // 9 MB are enough; with the pictures of both it took 44.
    const test::MemoryLimit limit(test::allocatedBytes() + 20'000'000);
    const auto done = model.change(back);
    ASSERT_TRUE(done.ok()) << done.error().message;
    EXPECT_EQ(model.report().training.steps, steps);
    ASSERT_TRUE(model.step(50.0).ok());
}

// Lost while it learns, judges, copies or is offered something: what is shown stays, and another device goes
// on as if nothing had happened.
TEST_F(PeripheralChange, AnotherDeviceGoesOnWhereOneWasLost) {
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
        EXPECT_EQ(model.change(changedStart()).error().code, ErrorCode::deviceLost);
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
TEST_F(PeripheralChange, GoesOnFromAFile) {
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

TEST_F(PeripheralChange, WhatIsStillShownOfBeforeIsResumedToo) {
    PeripheralModel model = begun(neverPaused());
    giveWanted(model, truth(), 6);
    ASSERT_TRUE(model.step(50.0).ok());
    const auto shown = model.shown().splats;
    ModelStart warm = changedStart();
    warm.splats = {};
    ASSERT_TRUE(model.change(warm).ok());
    giveWanted(model, changed(), 2);
    auto resumed = PeripheralModel::resume(device(), model.lastGood(), neverPaused());
    ASSERT_TRUE(resumed.ok());
    EXPECT_TRUE(resumed->shown().isOfBefore);
    EXPECT_TRUE(sameBits(*resumed->shown().splats, *shown));
    EXPECT_EQ(resumed->report().views, 1u);
    const auto a = resumed->wantedView().value();
    const auto b = model.wantedView().value();
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->camera.positionMm, b->camera.positionMm);
    const auto three = [](PeripheralModel& m) {
        const auto goOn = [n = 0]() mutable { return ++n < 3; };
        EXPECT_TRUE(m.step(1e6, goOn).ok());
        return m.state()->training.splats;
    };
    EXPECT_TRUE(sameBits(three(*resumed), three(model))) << "to the same bits";
}

}  // namespace
}  // namespace macula::hybrid
