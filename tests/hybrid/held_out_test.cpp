// Which pictures are held out, and how they are made smaller.
#include "pipeline/hybrid/held_out.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "pipeline/hybrid/view_sampling.h"

namespace macula::hybrid {
namespace {

std::vector<std::size_t> heldOutOf(std::size_t views) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < views; ++i)
        if (isHeldOut(i, numbers.size())) numbers.push_back(i);
    return numbers;
}

TEST(HeldOut, AreFewAndSoon) {
    EXPECT_EQ(heldOutOf(5), (std::vector<std::size_t>{0, 3}));
    EXPECT_EQ(heldOutOf(1000), (std::vector<std::size_t>{0, 3, 7, 14, 21, 28}));
}

// Of the views that a model begins with: not all from one side, whatever the draw.
TEST(HeldOut, AreFromAllSides) {
    const Box box{glm::dvec3(-100.0), glm::dvec3(100.0)};
    for (std::uint64_t trial = 0; trial < 20; ++trial) {
        const auto views = sampleViews(box, initialTraining(48, trial));
        ASSERT_TRUE(views.ok());
        glm::dvec3 low(1.0);
        glm::dvec3 high(-1.0);
        for (const std::size_t i : heldOutOf(48)) {
            const glm::dvec3 from = glm::normalize((*views)[i].camera.positionMm);
            low = glm::min(low, from);
            high = glm::max(high, from);
        }
        const glm::dvec3 span = high - low;
        EXPECT_GT(std::min({span.x, span.y, span.z}), 0.5) << trial;
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
