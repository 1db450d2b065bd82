// What tests of states of training and their files share.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "pipeline/splat/model/splat_components.h"
#include "pipeline/splat/train/training_state.h"
#include "splat/model_support.h"

namespace macula::splat::testing {

// Bit for bit, pictures too.
inline void expectSame(const TrainingState& a, const TrainingState& b, const std::string& when) {
    EXPECT_EQ(a.trainerVersion, b.trainerVersion) << when;
    EXPECT_EQ(a.steps, b.steps) << when;
    EXPECT_EQ(a.options.key, b.options.key) << when;
    EXPECT_EQ(a.options.capacity, b.options.capacity) << when;
    EXPECT_TRUE(sameBits(a.splats, b.splats)) << when;
    EXPECT_EQ(a.optimizer.stepsDone, b.optimizer.stepsDone) << when;
    EXPECT_TRUE(sameBits(a.optimizer.steps, b.optimizer.steps)) << when;
    EXPECT_TRUE(sameBits(a.optimizer.first, b.optimizer.first)) << when;
    EXPECT_TRUE(sameBits(a.optimizer.second, b.optimizer.second)) << when;
    EXPECT_TRUE(sameBits(a.statistics, b.statistics)) << when;
    ASSERT_EQ(a.views.size(), b.views.size()) << when;
    for (std::size_t i = 0; i < a.views.size(); ++i) {
        const RasterView& v = a.views[i].given->view;
        const RasterView& w = b.views[i].given->view;
        EXPECT_EQ(v.cameraFromWorld, w.cameraFromWorld) << when;
        EXPECT_EQ(v.eyeMm, w.eyeMm) << when;
        EXPECT_EQ(v.focalPx, w.focalPx) << when;
        EXPECT_EQ(v.principalPx, w.principalPx) << when;
        EXPECT_EQ(v.sizePx, w.sizePx) << when;
        EXPECT_EQ(v.nearMm, w.nearMm) << when;
        EXPECT_EQ(a.views[i].loss, b.views[i].loss) << when;
        EXPECT_EQ(a.views[i].l1, b.views[i].l1) << when;
        EXPECT_EQ(a.views[i].given->weight, b.views[i].given->weight) << when;
        EXPECT_EQ(a.views[i].given->kind, b.views[i].given->kind) << when;
        EXPECT_TRUE(sameBits(a.views[i].given->pixels, b.views[i].given->pixels)) << when;
    }
}

// Valid, of numbers that have all their digits; pictures with some of which nothing is known.
inline TrainingState randomState(std::size_t splats, int degree, std::size_t views, const glm::ivec2& sizePx,
                                 unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    TrainingState state;
    state.splats = randomModel(splats, degree, seed);
    state.steps = (std::uint64_t(1) << 40) + 3;
    state.options.capacity = static_cast<std::uint32_t>(splats) + 5;
    state.options.seed = 0xfedcba98u;
    state.options.key = "line one\nline two, and a zero: ";
    state.options.key.push_back('\0');
    state.options.keepEveryMs = 1.0 / 3.0;
    state.options.density = {.firstStep = 1, .every = 2, .lastStep = 3, .unseenShare = 1.0 / 7.0};
    state.options.stages = {{.firstStep = 0, .halvings = 3}, {.firstStep = ~std::uint64_t(0), .halvings = 0}};
    state.options.optimizer.position = 1.0 / 7.0;
    state.options.optimizer.positionSteps = 12345678901234567u;
    state.options.loss = {.dssimWeight = 1.0f / 3.0f, .encode = LossEncoding::display, .exposure = 0.1f};
    state.optimizer.stepsDone = state.steps;
    const std::size_t numbers = splats * static_cast<std::size_t>(componentCount(degree));
    for (std::size_t i = 0; i < splats; ++i) {
        state.optimizer.steps.push_back(static_cast<std::uint32_t>(random()));
        state.statistics.push_back({uniform(), uniform(), uniform(), uniform()});
    }
    for (std::size_t i = 0; i < numbers; ++i) {
        state.optimizer.first.push_back(1e-3f * (uniform() - 0.5f));
        state.optimizer.second.push_back(1e-20f * uniform());
    }
    for (std::size_t v = 0; v < views; ++v) {
        const Camera camera{.positionMm = {100.0 * double(v), -500.0, 1.0 / 3.0}};
        TrainingView view{.view = *rasterView(camera, sizePx + glm::ivec2(int(v), 0), {0.1, 0.2, 0.3}),
                          .weight = 0.1f + uniform(),
                          .kind = static_cast<ViewKind>(v % 3)};
        const auto pixels = static_cast<std::size_t>(view.view.sizePx.x) * std::size_t(view.view.sizePx.y);
        for (std::size_t i = 0; i < pixels; ++i) {
            const bool empty = i % 3 == 0;
            view.pixels.push_back(empty ? glm::vec4(0.0f) : glm::vec4(uniform(), uniform(), uniform(), 1.0f));
        }
        view.pixels[1].x = std::nanf("7");
        state.views.push_back({.given = std::make_shared<const TrainingView>(std::move(view)),
                               .loss = v == 0 ? -1.0 : double(uniform()),
                               .l1 = double(uniform())});
    }
    return state;
}

}  // namespace macula::splat::testing
