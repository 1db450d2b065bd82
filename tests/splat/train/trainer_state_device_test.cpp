// Going on where training stopped: from a state of any step, and after the device was lost.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "base/new_process.h"
#include "gpu/lose_device.h"
#include "pipeline/splat/files/training_file.h"
#include "splat/train/training_scene.h"
#include "splat/training_support.h"

namespace macula::splat {
namespace {

namespace fs = std::filesystem;
using test::VulkanCall;
using testing::expectSame;

class TrainerState : public TrainingTest {
  protected:
    static constexpr std::uint64_t kLast = 20;

    void TearDown() override {
        test::loseDeviceAt(VulkanCall::submit, 1, 0);
        gpu::SharedDeviceTest::TearDown();
    }

    // Pictures of three sizes, and splats that go and are split, both at steps of their own.
    static TrainerOptions threeSizes() {
        TrainerOptions o = options();
        o.capacity = 80;
        o.density = {.firstStep = 7, .every = 4, .lastStep = 15};
        o.stages = {{.firstStep = 0, .halvings = 2},
                    {.firstStep = 6, .halvings = 1},
                    {.firstStep = 12, .halvings = 0}};
        o.key = "a volume, a preset";
        return o;
    }
    // Large enough to be halved twice.
    static std::vector<TrainingView> largerViews() {
        std::vector<TrainingView> made;
        for (int i = 0; i < kViews; ++i) {
            RasterView view = viewNumber(i);
            view.sizePx = {71, 66};
            view.principalPx = {35.5, 33.0};
            made.push_back({.view = view, .pixels = draw(truth(), view), .weight = 1.0f + float(i)});
        }
        return made;
    }
};

constexpr const char* kFolder = "MACULA_TEST_FOLDER";

TEST_F(TrainerState, GoesOnAsIfItHadNeverStopped) {
    Trainer whole = trainer(start(1), threeSizes(), largerViews());
    std::vector<TrainingState> states;
    for (std::uint64_t step = 0; step < kLast; ++step) {
        states.push_back(*whole.state());
        EXPECT_EQ(states.back().steps, step);
        ASSERT_TRUE(whole.step(1).ok());
    }
    const TrainingState expected = *whole.state();
    EXPECT_FALSE(testing::sameBits(expected.splats, states.back().splats));
    EXPECT_GT(expected.statistics.front().views, 0.0f);
    EXPECT_NE(expected.splats.size(), kSplats);
    for (const TrainingState& state : states) {
        const std::string when = fmt::format("from {}", state.steps);
        auto resumed = Trainer::resume(device(), state);
        ASSERT_TRUE(resumed.ok()) << when << resumed.error().message;
        expectSame(resumed->lastGood(), state, when);
        ASSERT_TRUE(resumed->step(kLast - state.steps).ok());
        expectSame(*resumed->state(), expected, when);
    }
}

TEST_F(TrainerState, GoesBackToWhatItKept) {
    TrainerOptions seldom = threeSizes();
    seldom.keepEveryMs = 1e9;
    Trainer trained = trainer(start(1), seldom, largerViews());
    ASSERT_TRUE(trained.step(3).ok());
    Trainer kept = std::move(Trainer::resume(device(), *trained.state())).value();
    const TrainingState then = kept.lastGood();
    ASSERT_TRUE(kept.step(15).ok());
    EXPECT_NE(kept.state()->splats.size(), then.splats.size()) << "splats were split meanwhile";
    ASSERT_TRUE(kept.goBack().ok());
    expectSame(*kept.state(), then, "gone back");
    EXPECT_EQ(kept.report().steps, 3u);
    // And goes on from there.
    ASSERT_TRUE(kept.step(kLast - 3).ok());
    ASSERT_TRUE(trained.step(kLast - 3).ok());
    expectSame(*kept.state(), *trained.state(), "gone on");
}

// The same by a file, in a process that knows nothing else.
TEST_F(TrainerState, GoesOnInANewProcess) {
    std::string name = (fs::temp_directory_path() / "macula-resume-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    Trainer whole = trainer(start(1), threeSizes(), largerViews());
    for (std::uint64_t step = 0; step < kLast; ++step) {
        ASSERT_TRUE(writeTraining(folder / fmt::format("from{}.macula", step), *whole.state()).ok());
        ASSERT_TRUE(whole.step(1).ok());
    }
    ASSERT_EQ(setenv(kFolder, folder.c_str(), 1), 0);
    EXPECT_EQ(test::runInNewProcess("TrainerState.DISABLED_NewProcess"), 0);
    unsetenv(kFolder);
    const TrainingState expected = *whole.state();
    for (std::uint64_t step = 0; step < kLast; ++step) {
        const auto state = readTraining(folder / fmt::format("to{}.macula", step));
        ASSERT_TRUE(state.ok()) << state.error().message;
        expectSame(*state, expected, fmt::format("from {}", step));
    }
    fs::remove_all(folder);
}

// What the one before has done elsewhere: each file from*.macula goes on to kLast, as to*.macula.
TEST_F(TrainerState, DISABLED_NewProcess) {
    const char* named = std::getenv(kFolder);
    if (named == nullptr) GTEST_SKIP();
    const fs::path folder = named;
    for (std::uint64_t step = 0; step < kLast; ++step) {
        const auto state = readTraining(folder / fmt::format("from{}.macula", step));
        ASSERT_TRUE(state.ok()) << state.error().message;
        auto resumed = Trainer::resume(device(), *state);
        ASSERT_TRUE(resumed.ok()) << resumed.error().message;
        ASSERT_TRUE(resumed->step(kLast - state->steps).ok());
        ASSERT_TRUE(writeTraining(folder / fmt::format("to{}.macula", step), *resumed->state()).ok());
    }
}

TEST_F(TrainerState, GoesOnInAnotherWayWithAllThatItKnows) {
    Trainer whole = trainer(start(), threeSizes(), largerViews());
    Trainer same = trainer(start(), threeSizes(), largerViews());
    ASSERT_TRUE(whole.step(9).ok());
    ASSERT_TRUE(same.step(9).ok());
    ASSERT_TRUE(same.goOnWith(threeSizes(), 0).ok());
    expectSame(same.lastGood(), *whole.state(), "told the same again");
    ASSERT_TRUE(whole.step(9).ok());
    ASSERT_TRUE(same.step(9).ok());
    expectSame(*same.state(), *whole.state(), "told the same again, later");

    TrainerOptions roomier = threeSizes();
    roomier.capacity = 90;
    roomier.density = {.firstStep = 20, .every = 1, .lastStep = 22, .splitShare = 0.5};
    ASSERT_TRUE(same.goOnWith(roomier, 1).ok());
    EXPECT_TRUE(testing::sameBits(same.snapshot()->position, whole.snapshot()->position));
    EXPECT_TRUE(testing::sameBits(draw(*same.snapshot(), heldOut()), draw(*whole.snapshot(), heldOut())));
    ASSERT_TRUE(same.step(1).ok());
    const TrainingState state = *same.state();
    EXPECT_EQ(state.splats.shDegree, 1);
    ASSERT_TRUE(same.step(3).ok());
    EXPECT_EQ(same.report().splats, 90u);
    EXPECT_TRUE(std::any_of(state.splats.sh.begin(), state.splats.sh.end(),
                            [](const glm::vec3& sh) { return sh != glm::vec3(0.0f); }));
    auto resumed = Trainer::resume(device(), state);
    ASSERT_TRUE(resumed.ok());
    ASSERT_TRUE(resumed->step(3).ok());
    expectSame(*resumed->state(), *same.state(), "stopped after that");

    // What makes no sense changes nothing.
    TrainerOptions senseless = roomier;
    senseless.density.every = 0;
    EXPECT_EQ(same.goOnWith(senseless, 1).error().code, ErrorCode::usage);
    expectSame(*same.state(), *resumed->state(), "refused");
    EXPECT_EQ(same.viewCount(), std::size_t(kViews));
    EXPECT_TRUE(same.step(1).ok());
}

TEST_F(TrainerState, OfAnotherTrainerOrDamagedIsRefused) {
    Trainer trained = trainer(start(), threeSizes(), truthViews());
    const TrainingState good = *trained.state();
    const auto refused = [&](const TrainingState& state, const std::string& says) {
        const auto resumed = Trainer::resume(device(), state);
        ASSERT_FALSE(resumed.ok());
        EXPECT_EQ(resumed.error().code, ErrorCode::inputNotUsable);
        EXPECT_NE(resumed.error().message.english().find(says), std::string::npos) << resumed.error().message;
    };
    TrainingState bad = good;
    bad.trainerVersion = kTrainerVersion + 7;
    refused(bad, fmt::format("version {}", kTrainerVersion + 7));
    refused(bad, fmt::format("version {}", kTrainerVersion));
    bad = good;
    bad.optimizer.first.pop_back();
    refused(bad, "damaged");
    bad = good;
    bad.statistics.pop_back();
    refused(bad, "damaged");
    bad = good;
    bad.views[1].given = nullptr;
    refused(bad, "damaged");
    bad = good;
    bad.options.capacity = 3;
    refused(bad, "damaged");
    bad = good;
    bad.splats.dc[0].x = std::nanf("");
    refused(bad, "not numbers");
}

// At calls to the driver spread over two steps and the copies that are kept after each.
TEST_F(TrainerState, TheLastGoodModelSurvivesTheDevice) {
    TrainerOptions o = options(2);
    o.keepEveryMs = 0.0;
    std::vector<TrainingState> expected;
    Trainer whole = trainer(start(), o, truthViews());
    for (std::uint64_t step = 0; step <= 6; ++step) {
        expected.push_back(*whole.state());
        ASSERT_TRUE(whole.step(1).ok());
    }
    int losses = 0;
    for (const auto& [call, nth] : {std::pair(VulkanCall::submit, 1), std::pair(VulkanCall::submit, 9),
                                    std::pair(VulkanCall::wait, 4), std::pair(VulkanCall::allocate, 1)}) {
        const std::string when = fmt::format("call {} number {}", int(call), nth);
        const auto doomed = *gpu::Device::create(instance());
        Trainer trained = trainer(start(), o, truthViews(), doomed);
        ASSERT_TRUE(trained.step(1).ok());
        test::loseDeviceAt(call, nth);
        const auto done = trained.step(5);
        ASSERT_EQ(test::devicesLost(), 1) << when;
        ++losses;
        ASSERT_FALSE(done.ok()) << when;
        EXPECT_EQ(done.error().code, ErrorCode::deviceLost) << when;
        EXPECT_EQ(trained.snapshot().error().code, ErrorCode::deviceLost) << when;
        EXPECT_EQ(trained.state().error().code, ErrorCode::deviceLost) << when;
        EXPECT_EQ(trained.addView(truthViews().front()).error().code, ErrorCode::deviceLost) << when;
        const TrainingState left = trained.lastGood();
        ASSERT_GE(left.steps, 1u) << when;
        ASSERT_LE(left.steps, 6u) << when;
        EXPECT_LE(trained.report().steps, left.steps + 1) << when;
        expectSame(left, expected[left.steps], when);
        if (nth < 9) continue;
        auto resumed = Trainer::resume(device(), left);
        ASSERT_TRUE(resumed.ok()) << when;
        ASSERT_TRUE(resumed->step(6 - left.steps).ok());
        expectSame(*resumed->state(), expected[6], when);
    }
    EXPECT_EQ(losses, 4);
}

// Before any step, and a view that came after the last copy.
TEST_F(TrainerState, WhatIsKeptIsWholeFromTheStart) {
    TrainerOptions o = options();
    o.keepEveryMs = 1e9;
    Trainer trained = trainer(start(), o, {truthViews()[0]});
    ASSERT_TRUE(trained.step(2).ok());
    EXPECT_EQ(trained.lastGood().steps, 0u);
    ASSERT_TRUE(trained.addView(truthViews()[1]).ok());
    const TrainingState& kept = trained.lastGood();
    EXPECT_TRUE(testing::sameBits(kept.splats, start()));
    EXPECT_EQ(kept.options.capacity, kNumber);
    ASSERT_EQ(kept.views.size(), 2u);
    EXPECT_TRUE(testing::sameBits(kept.views[1].given->pixels, truthViews()[1].pixels));
    auto resumed = Trainer::resume(device(), kept);
    ASSERT_TRUE(resumed.ok());
    EXPECT_EQ(resumed->viewCount(), 2u);
    EXPECT_TRUE(resumed->step(1).ok());
}

}  // namespace
}  // namespace macula::splat
