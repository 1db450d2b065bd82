// Which splats go and which are split, without a device.
#include "pipeline/splat/model/density_control.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula::splat {
namespace {

Splats lineOf(std::size_t count, int degree = 1) {
    Splats splats;
    splats.resize(count);
    splats.setShDegree(degree);
    for (std::size_t i = 0; i < count; ++i) {
        splats.position[i] = {float(i), 0, 0};
        splats.dc[i] = glm::vec3(float(i));
        for (std::size_t k = 0; k < shCount(degree); ++k)
            splats.sh[i * shCount(degree) + k] = glm::vec3(float(10 * i + k));
    }
    return splats;
}

shared::SplatStatistics seen(float weight, float pull) {
    return {.views = 2.0f, .weight = weight, .pull = 2.0f * pull, .mostWeight = weight};
}

TEST(DensityControl, DropsWhatTogetherHardlyShows) {
    const Splats splats = lineOf(4);
    const std::vector<shared::SplatStatistics> statistics{seen(100, 0), seen(0, 0), seen(0.5, 0), seen(2, 0)};
    const Regrouped result = regroup(splats, statistics, {.unseenShare = 0.01, .splitShare = 0.5}, 4);
    EXPECT_EQ(result.source, (std::vector<std::uint32_t>{0, 3}));
    EXPECT_EQ(result.isNew, (std::vector<std::uint8_t>{0, 0}));
    ASSERT_TRUE(result.splats.validate().ok());
    EXPECT_EQ(result.splats.size(), 2u);
    EXPECT_EQ(result.splats.position[1], splats.position[3]);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(result.splats.sh[3 + k], splats.sh[9 + k]);
}

// Its views were not drawn lately; in them it may be all there is.
TEST(DensityControl, KeepsWhatWasInNoView) {
    std::vector<shared::SplatStatistics> statistics{seen(100, 0), {}, seen(0, 0)};
    const Regrouped result = regroup(lineOf(3), statistics, {.unseenShare = 0.01, .splitShare = 0.0}, 3);
    EXPECT_EQ(result.source, (std::vector<std::uint32_t>{0, 1}));
}

TEST(DensityControl, SplitsWhatIsPulledMostAlongItsLongestAxis) {
    Splats splats = lineOf(10, 0);
    // A quarter turn about z: the splat's own y axis is the model's -x.
    splats.rotation[7] = {std::sqrt(0.5f), 0, 0, std::sqrt(0.5f)};
    splats.logScale[7] = {0.0f, std::log(4.0f), 0.0f};
    std::vector<shared::SplatStatistics> statistics(10, seen(1, 0.1f));
    statistics[7] = seen(1, 5.0f);
    const Regrouped result = regroup(splats, statistics, {.unseenShare = 0.0, .splitShare = 0.1}, 20);
    ASSERT_EQ(result.splats.size(), 11u);
    EXPECT_EQ(result.source[7], 7u);
    EXPECT_EQ(result.source[8], 7u);
    EXPECT_EQ(result.isNew[7], 1);
    EXPECT_EQ(result.isNew[8], 1);
    EXPECT_EQ(result.isNew[9], 0);
    const glm::vec3 apart = result.splats.position[8] - result.splats.position[7];
    EXPECT_NEAR(std::abs(apart.x), 2 * 0.6 * 4.0, 1e-4);
    EXPECT_NEAR(apart.y, 0.0, 1e-4);
    EXPECT_NEAR(result.splats.logScale[7].y, std::log(0.6 * 4.0), 1e-5);
    EXPECT_EQ(result.splats.logScale[7].x, 0.0f);
    const glm::vec3 middle = 0.5f * (result.splats.position[7] + result.splats.position[8]);
    EXPECT_LT(glm::distance(middle, splats.position[7]), 1e-5f);
}

TEST(DensityControl, NeverExceedsTheCapacity) {
    const Splats splats = lineOf(100);
    std::vector<shared::SplatStatistics> statistics(100, seen(1, 1));
    for (const std::uint32_t capacity : {100u, 103u, 1000u}) {
        const Regrouped result =
            regroup(splats, statistics, {.unseenShare = 0.0, .splitShare = 0.5}, capacity);
        EXPECT_EQ(result.splats.size(), std::min(capacity, 150u));
    }
}

TEST(DensityControl, WithoutKnowledgeNothingIsSplitAndNothingOfAModelIsLost) {
    const Splats splats = lineOf(5);
    const std::vector<shared::SplatStatistics> none(5, {0, 0, 0, 0});
    // All together show nothing, which is all there is to be shown: a model that no view has met yet stays.
    const Regrouped result = regroup(splats, none, {}, 100);
    EXPECT_EQ(result.splats.size(), 5u);
    EXPECT_TRUE(regroup(lineOf(0), {}, {}, 10).splats.validate().ok());
}

}  // namespace
}  // namespace macula::splat
