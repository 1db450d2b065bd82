// What of an older model is left, and what is added.
#include "pipeline/hybrid/model_start.h"

#include <gtest/gtest.h>

#include <random>

#include "pipeline/hybrid/nearest_points.h"

namespace macula::hybrid {
namespace {

std::vector<glm::vec3> randomPoints(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<glm::vec3> points(count);
    for (glm::vec3& point : points)
        for (int axis = 0; axis < 3; ++axis) point[axis] = float(random() % 4096) / 128.0f - 16.0f;
    return points;
}

TEST(NearestPoints, AreThoseThatAreFoundOneByOne) {
    const std::vector<glm::vec3> points = randomPoints(500, 1);
    const NearestPoints grid(points, 2.5);
    int found = 0;
    for (const glm::vec3& place : randomPoints(300, 2)) {
        std::optional<std::size_t> expected;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const float distance = glm::distance(points[i], place);
            if (distance <= 2.5f && (!expected || distance < glm::distance(points[*expected], place)))
                expected = i;
        }
        EXPECT_EQ(grid.nearest(place), expected);
        found += expected ? 1 : 0;
    }
    EXPECT_GT(found, 50);
    EXPECT_LT(found, 290);
    EXPECT_FALSE(grid.nearest(glm::vec3(1e30f)));
    EXPECT_FALSE(NearestPoints({}, 1.0).nearest(glm::vec3(0.0f)));
}

// Splats along a line, 2 mm apart, at x = from to x = to.
splat::Splats line(int from, int to, const glm::vec3& colour) {
    splat::Splats splats;
    splats.resize(std::size_t(to - from));
    for (int i = from; i < to; ++i) {
        splats.position[std::size_t(i - from)] = {2.0f * float(i), 0.0f, 0.0f};
        splats.dc[std::size_t(i - from)] = colour;
    }
    return splats;
}

TEST(MergedSplats, HaveWhatIsStillThereInItsNewColoursAndWhatIsNew) {
    const glm::vec3 red(1, 0, 0);
    const glm::vec3 blue(0, 0, 1);
    splat::Splats older = line(0, 10, red);
    for (glm::vec3& scale : older.logScale) scale = glm::vec3(0.25f);
    older.setShDegree(1);
    older = relativeTo(older, {100.0, 0.0, 0.0});
    const splat::Splats points = line(5, 20, blue);
    const splat::Splats merged = mergedSplats(older, points, 1.9);
    ASSERT_TRUE(merged.validate().ok());
    EXPECT_EQ(merged.originMm, points.originMm);
    EXPECT_EQ(merged.shDegree, 1);
    // Of the older ones those from 8 mm on, 2 mm before the first point, up to 18 mm; then points.
    ASSERT_EQ(merged.size(), 16u);
    for (std::size_t i = 0; i < merged.size(); ++i) {
        EXPECT_NEAR(merged.position[i].x, 8.0f + 2.0f * float(i), 1e-4f);
        EXPECT_EQ(merged.dc[i], blue);
        EXPECT_EQ(merged.logScale[i].x, i < 6 ? 0.25f : points.logScale[0].x);
    }
    EXPECT_EQ(mergedSplats({}, points, 2.0).size(), points.size());
    EXPECT_EQ(mergedSplats(older, {}, 2.0).size(), 0u);
}

TEST(RelativeTo, MovesTheOriginAndNothingElse) {
    splat::Splats splats = line(0, 3, glm::vec3(0.0f));
    splats.originMm = {10.0, 20.0, 30.0};
    const splat::Splats moved = relativeTo(splats, {11.0, 20.0, 28.0});
    EXPECT_EQ(moved.position[2], glm::vec3(3.0f, 0.0f, 2.0f));
    EXPECT_EQ(boundingBox(moved).low, boundingBox(splats).low);
}

}  // namespace
}  // namespace macula::hybrid
