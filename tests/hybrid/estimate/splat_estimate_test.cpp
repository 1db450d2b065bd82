// What an edit makes of a model: what is hidden goes, what comes to light is there, and its light is right.
#include "pipeline/hybrid/estimate/splat_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "pipeline/splat/draw/displayed.h"
#include "pipeline/splat/model/constant_colour.h"
#include "pipeline/volume/medium.h"
#include "pipeline/volume/window.h"
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

// Of a cut at x = 4 mm; black is 0, white 1000.
ShownMatter cutWithGreyFace(const CoarseMatter& matter, bool belowIsBlack = false) {
    Clip clip;
    clip.planes = {{.normal = {1.0, 0.0, 0.0}, .offsetMm = 4.0}};
    clip.greyFaces = DisplayWindow{.center = 500.0, .width = 1000.0, .function = "LINEAR_EXACT"};
    ShownMatter shown = shownBy(matter, curve(200), clip);
    const auto [low, high] = entriesOf(*clip.greyFaces, matter.volume());
    shown.faces = GreyValues{.low = low, .high = high, .belowIsBlack = belowIsBlack, .exposure = 2.0f};
    return shown;
}

bool isOnFace(const splat::Splats& splats, std::size_t i) {
    return std::abs(splats.position[i].x - 4.0f) < 1.5f;
}

TEST(SplatEstimateTest, AFaceOfGreyValuesShowsThem) {
    const auto matter = shellAndCore();
    const splat::Splats cut = learntFrom(matter, 200).under(cutWithGreyFace(*matter));
    ASSERT_TRUE(cut.validate());
    std::size_t ofCore = 0;
    std::size_t ofShell = 0;
    for (std::size_t i = 0; i < cut.size(); ++i) {
        EXPECT_GT(cut.position[i].x, 3.0f);
        const float fromMiddle = glm::length(glm::vec2(cut.position[i].y, cut.position[i].z));
        if (!isOnFace(cut, i) || fromMiddle > 20.0f) continue;
        EXPECT_LT(cut.logScale[i].z, cut.logScale[i].x);
        const glm::vec4 light(2.0f * splat::colourOfDc(cut.dc[i]), 1.0f);
        const glm::vec3 displayed =
            splat::displayedExactly(std::span(&light, 1), splat::ColourSpace::linear, {}).front();
        if (fromMiddle < 9.0f) {
            EXPECT_LT(glm::distance(displayed, glm::vec3(0.8f)), 0.01f);
            ++ofCore;
        } else if (fromMiddle > 13.0f) {
            EXPECT_LT(glm::distance(displayed, glm::vec3(0.3f)), 0.01f);
            ++ofShell;
        }
    }
    EXPECT_GT(ofCore, 100u);
    EXPECT_GT(ofShell, 300u);
}

// Samples are whole voxels, and not evenly apart in cells of an odd number of these.
TEST(SplatEstimateTest, NoFaceFallsBetweenSamples) {
    for (const int cells : {60, 30, 20, 15, 12}) {
        const CoarseMatter matter(scenes::volumeOf(kSize, scenes::grid(glm::dvec3(1.0), kSize),
                                                   [](int, int, int) { return std::uint16_t(500); }),
                                  std::size_t(cells) * std::size_t(cells) * std::size_t(cells));
        for (double offsetMm = -4.0; offsetMm < 4.0; offsetMm += 0.31) {
            ShownMatter shown = cutWithGreyFace(matter);
            shown.clip.planes.front().offsetMm = offsetMm;
            const std::size_t side = std::size_t(matter.size().y) * std::size_t(matter.size().z);
            EXPECT_GE(facePlaces(matter, shown).size(), side) << cells << " cells, at " << offsetMm;
        }
    }
}

TEST(SplatEstimateTest, WhereAFaceIsClearIsNothingAndWhereItIsBlackAWall) {
    const auto matter = shellAndCore();
    const auto countInAir = [](const splat::Splats& splats) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < splats.size(); ++i) {
            const bool isAir = glm::length(splats.position[i]) > kShellMm + 2.0;
            if (!isAir || !isOnFace(splats, i)) continue;
            EXPECT_LT(splat::colourOfDc(splats.dc[i]).r, 1e-3f);
            ++count;
        }
        return count;
    };
    const SplatEstimate estimate = learntFrom(matter, 200);
    EXPECT_EQ(countInAir(estimate.under(cutWithGreyFace(*matter))), 0u);
    EXPECT_GT(countInAir(estimate.under(cutWithGreyFace(*matter, true))), 500u);
}

// A face that was learnt is not left standing where the clip goes on.
TEST(SplatEstimateTest, FacesOfBeforeAreGone) {
    const auto matter = shellAndCore();
    const ShownMatter cut = cutWithGreyFace(*matter);
    const auto model = std::make_shared<const splat::Splats>(nothingLearnt(matter).under(cut));
    const SplatEstimate estimate(matter, model, cut, trace::Environment::constant(glm::vec3(0.8f)));
    EXPECT_EQ(estimate.under(cut).size(), model->size());
    const splat::Splats whole = estimate.under(shownBy(*matter, curve(200)));
    ASSERT_TRUE(whole.validate());
    std::size_t onOtherSide = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_GT(glm::length(whole.position[i]), kShellMm - 5.0) << "nothing stands inside";
        onOtherSide += whole.position[i].x < 0.0f ? 1 : 0;
    }
    EXPECT_GT(onOtherSide, 300u) << "what the cut had removed";
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
