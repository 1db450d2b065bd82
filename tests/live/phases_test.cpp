// Phases of a study in the renderer: shown in turn, learnt in the background, and played.
#include "live/frame/frame_renderer.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <vector>

#include "live/dark_renderer.h"

namespace macula::live {
namespace {

constexpr glm::ivec3 kSize{32, 28, 20};
constexpr int kPhases = 2;

// A block of bone in air, which moves to the patient's left by 3 cm from phase to phase.
std::shared_ptr<const Volume> blockOf(int phase, int finer = 1) {
    const glm::ivec3 size = kSize * finer;
    const glm::dvec3 spacingMm = glm::dvec3(10.0) / double(finer);
    VolumeOptions options{.size = size,
                          .unitsFromStored = {.slope = 1.0, .intercept = -1024.0},
                          .unit = Unit::hounsfield,
                          .modality = "CT"};
    for (int axis = 0; axis < 3; ++axis) options.worldFromVoxel[axis][axis] = spacingMm[axis];
    std::vector<std::uint16_t> voxels;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const glm::ivec3 at = glm::ivec3(i, j, k) / finer - glm::ivec3(6 + 3 * phase, 9, 6);
                const bool isInside = glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) &&
                                      glm::all(glm::lessThan(at, glm::ivec3(9, 9, 8)));
                voxels.push_back(isInside ? 1924 : 24);
            }
    return std::make_shared<const Volume>(Volume::create(std::move(options), std::move(voxels)).value());
}

class RendererOfPhases : public FrameRendererTest {
  protected:
    void SetUp() override {
        FrameRendererTest::SetUp();
        if (!renderer_) return;
        for (int phase = 0; phase < kPhases; ++phase) volumes_.push_back(blockOf(phase));
        input_.volume = volumes_.front();
        input_.camera = frameBox(input_.volume->worldBox(), ViewDirection::anterior, 20.0, 4.0 / 3.0);
        input_.phase = 1;
    }
    void show(int phase) {  // from 1
        shown_.reset();
        input_.phase = std::uint64_t(phase);
        input_.volume = volumes_.at(std::size_t(phase) - 1);
        renderer_->accept(input_);
    }
    bool seesPhase(int phase, OnScreen picture) {
        return stepUntil(
            [&] { return shown_ && shown_->phase == std::uint64_t(phase) && shown_->picture == picture; });
    }
    void learnAll() {
        input_.learnsPhases = true;
        auto wanted = std::make_shared<PhaseScenes>();
        for (int phase = 1; phase <= kPhases; ++phase)
            wanted->push_back({.phase = std::uint64_t(phase),
                               .volume = volumes_[std::size_t(phase) - 1],
                               .drawing = input_.drawing});
        input_.phases = std::move(wanted);
    }

    std::vector<std::shared_ptr<const Volume>> volumes_;
};

TEST_F(RendererOfPhases, AnotherPhaseIsTheSameStudyAndAnotherVolumeIsNot) {
    show(1);
    ASSERT_TRUE(seesPhase(1, OnScreen::traced));
    const int before = removed_;
    show(2);
    ASSERT_TRUE(seesPhase(2, OnScreen::traced));
    EXPECT_EQ(removed_, before) << "the picture of the same patient stays until the next";
    EXPECT_EQ(outline_->phase, 2u);
    // A volume that changes without its phase may be another patient's.
    input_.volume = blockOf(2);
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil([&] { return removed_ > before; }));
}

// What the process holds, with the device's memory: on a CPU device both are the same.
std::size_t heldBytes() {
    malloc_trim(0);
    std::ifstream file("/proc/self/statm");
    std::size_t pages = 0;
    std::size_t resident = 0;
    file >> pages >> resident;
    return resident * std::size_t(sysconf(_SC_PAGESIZE));
}

// 100 volumes of 3.5 MB in turn: were only one of ten kept, the process would grow by 35 MB.
TEST_F(RendererOfPhases, SwitchingKeepsNoMemory) {
    for (int phase = 0; phase < kPhases; ++phase) volumes_[std::size_t(phase)] = blockOf(phase, 4);
    input_.usesModel = false;
    const auto switchTo = [&](int phase) {
        show(phase);
        return stepUntil([&] { return shown_ && shown_->phase == std::uint64_t(phase); });
    };
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(switchTo(1 + i % kPhases));
    const std::size_t before = heldBytes();
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(switchTo(1 + (i + 2) % kPhases));
    EXPECT_LT(heldBytes(), before + (std::size_t(24) << 20));
}

// Learnt in the background, played, and found by the next opening: one test, because learning takes long.
TEST_F(RendererOfPhases, PhasesAreLearntAndPlayWithoutTheTracerNextTimeAtOnce) {
    learnAll();
    show(1);
    ASSERT_TRUE(stepUntil([&] { return phases_.learnt == std::size_t(kPhases); }));
    EXPECT_EQ(phases_.wanted, std::size_t(kPhases));
    EXPECT_EQ(shown_->phase, 1u) << "the picture is left alone";

    const int before = preparing_;
    input_.playsPhases = true;
    input_.interacting = true;
    std::vector<double> middles(kPhases, 0.0);
    for (int i = 0; i < 2 * kPhases; ++i) {
        const int phase = 1 + (i + 1) % kPhases;
        show(phase);
        ASSERT_TRUE(seesPhase(phase, OnScreen::model));
        EXPECT_GT(shown_->model.steps, 0u);
        EXPECT_FALSE(renderer_->hasWork()) << "until the next phase";
        middles.at(std::size_t(phase) - 1) = litColumn();
    }
    EXPECT_EQ(preparing_, before) << "no volume was brought to the device";
    // Splats lie where the block of their own phase is. To the right on screen is the patient's left. 3 cm
    // are more than two pixels.
    EXPECT_GT(middles[1], middles[0] + 1.5);
    // At rest the phase is traced.
    input_.playsPhases = false;
    input_.interacting = false;
    show(kPhases);
    ASSERT_TRUE(seesPhase(kPhases, OnScreen::traced));
    EXPECT_TRUE(failures_.empty());

    renderer_.reset();  // puts everything away
    // Each has a model of its own, under a name of its own.
    for (const auto& state : keeper_->kept_) {
        EXPECT_TRUE(state->validate().ok());
        keeper_->stored_[state->training.options.key] = state;
    }
    EXPECT_EQ(keeper_->stored_.size(), std::size_t(kPhases));
    phases_ = {};
    makeRenderer();
    std::uint64_t learnt = 0;
    onPhases_ = [&](const PhaseModelsChanged& now) { learnt += now.learning; };
    show(1);
    ASSERT_TRUE(stepUntil([&] { return phases_.learnt == std::size_t(kPhases); }));
    EXPECT_EQ(learnt, 0u) << "what is stored need not be learnt";
}

TEST_F(RendererOfPhases, WhatIsNotWantedAnyMoreIsNotLearnt) {
    learnAll();
    show(1);
    ASSERT_TRUE(stepUntil([&] { return phases_.learning != 0; }));
    input_.learnsPhases = false;
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil([&] { return phases_.learning == 0; }));
    EXPECT_LT(phases_.learnt, std::size_t(kPhases));
    input_.phases.reset();
    renderer_->accept(input_);
    ASSERT_TRUE(stepUntil([&] { return phases_.wanted == 0; }));
    EXPECT_TRUE(failures_.empty());
}

}  // namespace
}  // namespace macula::live
