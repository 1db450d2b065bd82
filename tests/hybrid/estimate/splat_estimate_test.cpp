// What an edit makes of a model: what is hidden goes, what comes to light is there, and its light is right.
#include "pipeline/hybrid/estimate/splat_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "pipeline/splat/model/constant_colour.h"
#include "pipeline/volume/medium.h"
#include "trace/extreme_scenes.h"

namespace macula::hybrid {
namespace {

constexpr glm::ivec3 kSize{60, 60, 60};
constexpr double kShellMm = 24.0;
constexpr double kCoreMm = 12.0;

// Air, a shell of 300 and a core of 800, in the middle of the world.
std::shared_ptr<const CoarseMatter> shellAndCore() {
    return std::make_shared<const CoarseMatter>(
        scenes::volumeOf(kSize, scenes::grid(glm::dvec3(1.0), kSize),
                         [](int i, int j, int k) {
                             const double r = glm::length(glm::dvec3(i, j, k) - 29.5);
                             return std::uint16_t(r < kCoreMm ? 800 : r < kShellMm ? 300 : 0);
                         }),
        30 * 30 * 30);
}

TransferFunction curve(double from, double opacity = 0.9) {
    TransferFunction function = scenes::ramp(from, from + 50, opacity, 1.0);
    function.colour = {{300, {0.9, 0.3, 0.2}}, {800, {0.9, 0.9, 0.85}}};
    return function;
}

ShownMatter shownBy(const CoarseMatter& matter, const TransferFunction& function, Clip clip = {}) {
    return {.optics = opticsByEntry(matter.volume(), function), .clip = std::move(clip), .mask = nullptr};
}

SplatEstimate nothingLearnt(const std::shared_ptr<const CoarseMatter>& matter) {
    return SplatEstimate(matter, std::make_shared<const splat::Splats>(), shownBy(*matter, curve(200)),
                         trace::Environment::constant(glm::vec3(0.8f)));
}

// A model of what a curve shows: as good as any that is not trained.
std::shared_ptr<const splat::Splats> modelOf(const std::shared_ptr<const CoarseMatter>& matter, double from) {
    splat::Splats splats = nothingLearnt(matter).under(shownBy(*matter, curve(from)));
    splats.setShDegree(1);
    return std::make_shared<const splat::Splats>(std::move(splats));
}

SplatEstimate learntFrom(const std::shared_ptr<const CoarseMatter>& matter, double from) {
    return SplatEstimate(matter, modelOf(matter, from), shownBy(*matter, curve(from)),
                         trace::Environment::constant(glm::vec3(0.8f)));
}

TEST(SplatEstimateTest, WithoutAModelMatterHasFlatSplatsOnItsSurface) {
    const auto matter = shellAndCore();
    const splat::Splats splats = nothingLearnt(matter).under(shownBy(*matter, curve(200)));
    ASSERT_TRUE(splats.validate());
    ASSERT_GT(splats.size(), 500u);
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const glm::vec3 at = splats.position[i];
        EXPECT_NEAR(glm::length(at), kShellMm - 1.5, 3.5) << "none deep inside";
        const glm::vec4 q = splats.rotation[i];
        const glm::vec3 thin = glm::mat3_cast(glm::quat(q[0], q[1], q[2], q[3]))[2];
        if (splats.logScale[i].z < splats.logScale[i].x) {
            EXPECT_GT(std::abs(glm::dot(thin, glm::normalize(at))), 0.8f);
        }
        const glm::vec3 colour = splat::colourOfDc(splats.dc[i]);
        EXPECT_GT(colour.r, 2.0f * colour.g);
        EXPECT_LT(colour.r, 0.9f);
    }
}

TEST(SplatEstimateTest, OfWhatItWasLearntOfItIsTheModel) {
    const auto matter = shellAndCore();
    const auto model = modelOf(matter, 200);
    const splat::Splats same = learntFrom(matter, 200).under(shownBy(*matter, curve(200)));
    ASSERT_EQ(same.size(), model->size());
    for (std::size_t i = 0; i < same.size(); ++i) {
        EXPECT_EQ(same.position[i], model->position[i]);
        EXPECT_NEAR(same.opacityLogit[i], model->opacityLogit[i], 1e-3f);
        EXPECT_LT(glm::distance(same.dc[i], model->dc[i]), 1e-5f);
    }
}

TEST(SplatEstimateTest, WhatTheCurveHidesIsGoneAndWhatItBaresIsThere) {
    const auto matter = shellAndCore();
    const splat::Splats core = learntFrom(matter, 200).under(shownBy(*matter, curve(600)));
    ASSERT_TRUE(core.validate());
    ASSERT_GT(core.size(), 100u);
    for (std::size_t i = 0; i < core.size(); ++i) {
        EXPECT_LT(glm::length(core.position[i]), kCoreMm + 3.0);
        if (core.logScale[i].z == core.logScale[i].x) continue;  // behind the surface
        const glm::vec3 colour = splat::colourOfDc(core.dc[i]);
        EXPECT_LT(colour.r, 1.7f * colour.b) << "it is white, and lit as the shell was";
        EXPECT_GT(colour.g, 0.15f);
    }
    EXPECT_EQ(learntFrom(matter, 200).under(shownBy(*matter, curve(3000))).size(), 0u);
}

TEST(SplatEstimateTest, AClipRemovesAndItsFaceIsThere) {
    const auto matter = shellAndCore();
    Clip clip;
    clip.planes = {{.normal = {1.0, 0.0, 0.0}, .offsetMm = 4.0}};
    const splat::Splats half = learntFrom(matter, 200).under(shownBy(*matter, curve(200), clip));
    ASSERT_TRUE(half.validate());
    std::size_t onFace = 0;
    for (std::size_t i = 0; i < half.size(); ++i) {
        EXPECT_GT(half.position[i].x, 3.0f);
        if (half.position[i].x < 8.0f && glm::length(half.position[i]) < 18.0f) ++onFace;
    }
    EXPECT_GT(onFace, 50u);
    Clip all;
    all.planes = {{.normal = {1.0, 0.0, 0.0}, .offsetMm = 400.0}};
    EXPECT_EQ(learntFrom(matter, 200).under(shownBy(*matter, curve(200), all)).size(), 0u);
}

TEST(SplatEstimateTest, OtherColoursAreThoseOfTheMatter) {
    const auto matter = shellAndCore();
    TransferFunction blue = curve(200);
    blue.colour = {{0, {0.2, 0.3, 0.9}}};
    const splat::Splats splats = learntFrom(matter, 200).under(shownBy(*matter, blue));
    const auto model = modelOf(matter, 200);
    ASSERT_EQ(splats.size(), model->size());
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const glm::vec3 colour = splat::colourOfDc(splats.dc[i]);
        EXPECT_GT(colour.b, 2.0f * colour.r);
        EXPECT_NEAR(splats.opacityLogit[i], model->opacityLogit[i], 1e-3f);
    }
}

TEST(SplatEstimateTest, NeverHasMoreNewSplatsThanItMay) {
    const auto matter = shellAndCore();
    const SplatEstimate few(matter, std::make_shared<const splat::Splats>(), shownBy(*matter, curve(200)),
                            trace::Environment::constant(glm::vec3(0.8f)), {.mostNewSplats = 40});
    EXPECT_EQ(few.under(shownBy(*matter, curve(200))).size(), 40u);
}

class SplatEstimateExtremes : public testing::TestWithParam<scenes::ExtremeScene> {};

TEST_P(SplatEstimateExtremes, IsValid) {
    const scenes::ExtremeScene& scene = GetParam();
    const auto matter = std::make_shared<const CoarseMatter>(scene.volume);
    splat::Splats none;
    const Box box = scene.volume->worldBox();
    none.originMm = 0.5 * (box.low + box.high);
    const ShownMatter shown = shownBy(*matter, scene.function);
    const SplatEstimate first(matter, std::make_shared<const splat::Splats>(none), shown, scene.environment);
    const auto model = std::make_shared<const splat::Splats>(first.under(shown));
    const Result<void> valid = model->validate();
    EXPECT_TRUE(valid) << valid.error().message;
    const SplatEstimate next(matter, model, shown, scene.environment);
    ShownMatter changed = shown;
    for (glm::vec4& optics : changed.optics) optics *= glm::vec4(0.5f, 0.5f, 0.5f, 1e6f);
    for (const ShownMatter& edited : {shown, changed}) {
        const splat::Splats splats = next.under(edited);
        const Result<void> isValid = splats.validate();
        EXPECT_TRUE(isValid) << isValid.error().message;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SplatEstimateExtremes, testing::ValuesIn(scenes::extremeScenes()),
                         [](const auto& scene) {
                             std::string name = scene.param.name;
                             std::erase_if(name, [](char c) {
                                 return std::isalnum(static_cast<unsigned char>(c)) == 0;
                             });
                             return name;
                         });

// Far more and far less than a model can be trained to.
TEST(SplatEstimateTest, SplatsAtTheirLimitsStayValid) {
    const auto matter = shellAndCore();
    splat::Splats wild = *modelOf(matter, 200);
    for (std::size_t i = 0; i < wild.size(); ++i) {
        wild.opacityLogit[i] = i % 2 == 0 ? 80.0f : -80.0f;
        wild.logScale[i] = glm::vec3(i % 3 == 0 ? 60.0f : -60.0f);
        wild.dc[i] = glm::vec3(i % 5 == 0 ? 1e30f : -1e30f);
        wild.position[i] *= i % 7 == 0 ? 1e12f : 1.0f;
    }
    const SplatEstimate estimate(matter, std::make_shared<const splat::Splats>(wild),
                                 shownBy(*matter, curve(200)), trace::Environment::constant(glm::vec3(0.8f)));
    EXPECT_TRUE(estimate.under(shownBy(*matter, curve(200))).validate());
    EXPECT_TRUE(estimate.under(shownBy(*matter, curve(600))).validate());
}

}  // namespace
}  // namespace macula::hybrid
