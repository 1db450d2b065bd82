// Which pictures are held out, and how they are made smaller.
#include "pipeline/hybrid/views/held_out.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "pipeline/hybrid/views/pose_sampling.h"

namespace macula::hybrid {
namespace {

// Of views from these directions.
std::vector<std::size_t> heldOutOf(const std::vector<glm::dvec3>& from) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < from.size(); ++i) {
        double beside = 180.0;
        for (const std::size_t k : numbers)
            beside =
                std::min(beside, glm::degrees(std::acos(glm::clamp(glm::dot(from[i], from[k]), -1.0, 1.0))));
        if (isHeldOut(i, numbers.size(), beside)) numbers.push_back(i);
    }
    return numbers;
}

TEST(HeldOut, AreFewAndSoonAndOfEachSideWhenItIsSeen) {
    std::vector<glm::dvec3> from(40, glm::dvec3(0, -1, 0));
    EXPECT_EQ(heldOutOf(from), (std::vector<std::size_t>{0, 3, 7, 14}));
    from[5] = {0, 1, 0};
    EXPECT_EQ(heldOutOf(from), (std::vector<std::size_t>{0, 3, 7, 14})) << "they would be too many";
    from[6] = from[20] = {0, 1, 0};
    EXPECT_EQ(heldOutOf(from), (std::vector<std::size_t>{0, 3, 6, 7}));
    from[30] = {1, 0, 0};
    from[31] = {0, 0, 1};
    from[32] = {-1, 0, 0};
    EXPECT_EQ(heldOutOf(from), (std::vector<std::size_t>{0, 3, 6, 7, 30, 31}));
}

// Of the views that a model begins with: not all from one side, whatever the draw.
TEST(HeldOut, AreFromAllSides) {
    const Box box{glm::dvec3(-100.0), glm::dvec3(100.0)};
    for (std::uint64_t trial = 0; trial < 20; ++trial) {
        const auto views = samplePoses(box, initialTraining(48, trial));
        ASSERT_TRUE(views.ok());
        std::vector<glm::dvec3> from;
        for (const SampledPose& view : *views) from.push_back(glm::normalize(view.camera.positionMm));
        const std::vector<std::size_t> heldOut = heldOutOf(from);
        EXPECT_GE(heldOut.size(), 4u);
        EXPECT_LE(heldOut.size(), kMostHeldOut);
        for (const glm::dvec3& any : from) {
            double nearest = -1.0;
            for (const std::size_t i : heldOut) nearest = std::max(nearest, glm::dot(any, from[i]));
            EXPECT_GT(nearest, -0.2) << trial;
        }
    }
}

TEST(HeldOut, AreReducedToWhatIsSeenInTheSamePlace) {
    const Camera camera{.positionMm = {0, -500, 0}, .verticalFovDeg = 20.0};
    splat::TrainingView view{.view = *splat::rasterView(camera, {90, 41}, glm::dvec3(0.0)), .weight = 0.7f};
    for (int y = 0; y < 41; ++y)
        for (int x = 0; x < 90; ++x) view.pixels.push_back({x, y, x * y, 0.5});
    const splat::TrainingView half = reducedTo(view, 60);
    EXPECT_EQ(half.view.sizePx, glm::ivec2(45, 20));
    ASSERT_EQ(half.pixels.size(), 900u);
    EXPECT_EQ(half.view.focalPx, 0.5 * view.view.focalPx);
    EXPECT_EQ(half.view.principalPx, 0.5 * view.view.principalPx) << "of the uneven row as well";
    EXPECT_EQ(half.pixels[45 * 3 + 2], glm::vec4(4.5f, 6.5f, 29.25f, 0.5f));
    EXPECT_EQ(half.weight, 0.7f);
    EXPECT_TRUE(splat::validate(half.view).ok());
    EXPECT_EQ(reducedTo(view, 22).view.sizePx, glm::ivec2(22, 10));
    EXPECT_EQ(reducedTo(view, 90).pixels.size(), view.pixels.size());

    EXPECT_NEAR(meanCoverage(view), 0.5, 1e-9);
    view.pixels.assign(4, glm::vec4(std::nanf("")));
    EXPECT_EQ(meanCoverage(view), 0.0);
    view.pixels[1].a = 0.25f;
    EXPECT_EQ(meanCoverage(view), 0.25);
}

}  // namespace
}  // namespace macula::hybrid
