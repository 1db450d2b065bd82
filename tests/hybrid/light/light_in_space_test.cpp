// Light that is kept by place.
#include "pipeline/hybrid/light/light_in_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <tuple>
#include <vector>

namespace macula::hybrid {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

glm::dvec3 anyDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

glm::dvec3 anyPlace(std::mt19937& random, double low, double high) {
    std::uniform_real_distribution<double> even(low, high);
    const double x = even(random);
    const double y = even(random);
    return {x, y, even(random)};
}

TEST(LightInSpace, IsWhatItWasFromEverySide) {
    std::mt19937 random(1);
    LightInSpace light(2.0);
    for (int i = 0; i < 20000; ++i)
        light.add(anyPlace(random, -10.0, 10.0), anyDirection(random), {0.25f, 0.5f, 4.0f});
    light.finish();
    EXPECT_EQ(light.cells(), 1000u);
    for (int i = 0; i < 100; ++i) {
        const auto seen = light.at(anyPlace(random, -9.9, 9.9), anyDirection(random));
        ASSERT_TRUE(seen.has_value());
        EXPECT_NEAR(seen->x, 0.25, 1e-5);
        EXPECT_NEAR(seen->y, 0.5, 1e-5);
        EXPECT_NEAR(seen->z, 4.0, 1e-4);
    }
}

// The same in double, from the samples themselves, where there are so many that what is around hardly counts.
TEST(LightInSpace, IsTheMeanOfWhatWasSeenAroundByPlaceAndSide) {
    struct Sample {
        glm::dvec3 atMm, direction, radiance;
    };
    std::mt19937 random(2);
    std::vector<Sample> samples;
    for (int i = 0; i < 200000; ++i) {
        const glm::dvec3 at = anyPlace(random, -4.0, 4.0);
        const glm::dvec3 direction = anyDirection(random);
        samples.push_back(
            {at, direction, {1.0 + 0.1 * at.x, 1.0 + 0.4 * direction.y, at.z > 0.0 ? 3.0 : 1.0}});
    }
    LightInSpace light(1.0);
    using Key = std::tuple<int, int, int, int>;
    std::map<Key, glm::dvec4> sums;
    for (const Sample& s : samples) {
        light.add(s.atMm, s.direction, glm::vec3(s.radiance));
        const glm::dvec3 cell = glm::floor(s.atMm);
        for (int axis = 0; axis < 3; ++axis) {
            const double along = s.direction[axis];
            sums[{int(cell.x), int(cell.y), int(cell.z), 2 * axis + (along < 0.0)}] +=
                along * along * glm::dvec4(s.radiance, 1.0);
        }
    }
    light.finish();
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 at = anyPlace(random, -3.4, 3.4);
        const glm::dvec3 direction = anyDirection(random);
        glm::dvec3 expected(0.0);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
            const glm::dvec3 low = glm::floor(at - 0.5);
            const glm::dvec3 near = 1.0 - glm::abs(at - 0.5 - (low + step));
            const glm::dvec3 cell = low + step;
            for (int axis = 0; axis < 3; ++axis) {
                const glm::dvec4 sum =
                    sums.at({int(cell.x), int(cell.y), int(cell.z), 2 * axis + (direction[axis] < 0.0)});
                expected +=
                    near.x * near.y * near.z * direction[axis] * direction[axis] * glm::dvec3(sum) / sum.w;
            }
        }
        const auto seen = light.at(at, direction);
        ASSERT_TRUE(seen.has_value());
        // Some 65 samples for each side of a cell: what is around counts for a 130th.
        for (int c = 0; c < 3; ++c) EXPECT_NEAR((*seen)[c], expected[c], 0.02 * expected[c]);
    }
}

// Thinner than a cell: red in front, blue behind.
TEST(LightInSpace, KeepsTheSidesOfAThinWallApart) {
    LightInSpace light(1.0);
    for (int i = 0; i < 40; ++i) {
        light.add({0.5, 0.4, 0.5}, {0, 1, 0}, {1, 0, 0});
        light.add({0.5, 0.6, 0.5}, {0, -1, 0}, {0, 0, 1});
    }
    light.finish();
    const auto front = light.at({0.5, 0.5, 0.5}, {0, 1, 0});
    const auto back = light.at({0.5, 0.5, 0.5}, {0, -1, 0});
    ASSERT_TRUE(front && back);
    EXPECT_GT(front->x, 0.98f);
    EXPECT_LT(front->z, 0.02f);
    EXPECT_GT(back->z, 0.98f);
    EXPECT_LT(back->x, 0.02f);
    // From aside nobody has looked: what is known of it is both.
    const auto aside = light.at({0.5, 0.5, 0.5}, {1, 0, 0});
    ASSERT_TRUE(aside);
    EXPECT_NEAR(aside->x, 0.5, 0.05);
    EXPECT_NEAR(aside->z, 0.5, 0.05);
}

TEST(LightInSpace, FewSamplesAreDrawnToWhatIsAround) {
    LightInSpace light(1.0);
    for (int x = 0; x < 8; ++x)
        for (int i = 0; i < 50; ++i) light.add({x + 0.5, 0.5, 0.5}, {0, 0, 1}, glm::vec3(1.0f));
    light.add({2.5, 1.5, 0.5}, {0, 0, 1}, glm::vec3(100.0f));  // one path that was lucky
    light.finish();
    const auto lucky = light.at({2.5, 1.5, 0.5}, {0, 0, 1});
    ASSERT_TRUE(lucky);
    EXPECT_LT(lucky->x, 80.0f);
    EXPECT_GT(lucky->x, 1.0f);
    EXPECT_NEAR(light.at({6.5, 0.5, 0.5}, {0, 0, 1})->x, 1.0, 0.02);
}

TEST(LightInSpace, IsNotKnownWhereNothingWasSeen) {
    LightInSpace light(1.0);
    light.finish();
    EXPECT_FALSE(light.at({0, 0, 0}, {1, 0, 0}));
    LightInSpace one(1.0);
    one.add({0.5, 0.5, 0.5}, {1, 0, 0}, glm::vec3(2.0f));
    one.finish();
    EXPECT_TRUE(one.at({1.4, 0.5, 0.5}, {1, 0, 0}));
    EXPECT_FALSE(one.at({1.6, 0.5, 0.5}, {1, 0, 0}));
    EXPECT_FALSE(one.at({kNan, 0.5, 0.5}, {1, 0, 0}));
    EXPECT_FALSE(one.at({0.5, kNan, 0.5}, {1, 0, 0}));
    EXPECT_FALSE(one.at({0.5, 0.5, kNan}, {1, 0, 0}));
    EXPECT_FALSE(one.at({1e300, 0.5, 0.5}, {1, 0, 0}));
}

TEST(LightInSpace, LeavesOutWhatIsNoNumberOrTooFar) {
    LightInSpace light(1.0);
    const float infinity = std::numeric_limits<float>::infinity();
    light.add({0.5, 0.5, 0.5}, {1, 0, 0}, {1.0f, infinity, 1.0f});
    light.add({0.5, 0.5, 0.5}, {1, 0, 0}, {1.0f, std::nanf(""), 1.0f});
    light.add({kNan, 0.5, 0.5}, {1, 0, 0}, glm::vec3(1.0f));
    light.add({0.5, kNan, 0.5}, {1, 0, 0}, glm::vec3(1.0f));
    light.add({0.5, 0.5, kNan}, {1, 0, 0}, glm::vec3(1.0f));
    light.add({0.5, 1e9, 0.5}, {1, 0, 0}, glm::vec3(1.0f));
    light.add({0.5, 0.5, -1e300}, {1, 0, 0}, glm::vec3(1.0f));
    EXPECT_EQ(light.cells(), 0u);
    for (const float radiance : {0.0f, 1e-40f, 3e38f, 3e38f})
        light.add({0.5, 0.5, 0.5}, {1, 0, 0}, glm::vec3(radiance));
    light.finish();
    EXPECT_EQ(light.cells(), 1u);
    const auto bright = light.at({0.5, 0.5, 0.5}, {1, 0, 0});
    ASSERT_TRUE(bright);
    EXPECT_NEAR(bright->x, 5e5, 1.0) << "two of four count as the most there is";
}

std::vector<shared::PrimaryVertex> anyVertices(std::size_t count, float reachMm) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> even(-reachMm, reachMm);
    std::vector<shared::PrimaryVertex> met(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 5 == 0) continue;  // met nothing
        const float x = even(random);
        const float y = even(random);
        met[i] = {.fromEyeMm = {x, y, even(random)}, .radiance = {1.0f, float(i % 7), 0.1f}};
        if (i % 1001 == 1) met[i].radiance.y = std::nanf("");
        if (i % 1003 == 1) met[i].fromEyeMm.z = std::nanf("");
    }
    return met;
}

// To the bit, and where cells become larger in between.
TEST(LightInSpace, OfManyAtOnceIsThatOfOneAfterTheOther) {
    const glm::dvec3 eyeMm(3.0, -500.25, 7.5);
    for (const std::size_t count : {0u, 1u, 4u, 16384u, 50001u}) {
        SCOPED_TRACE(count);
        const auto met = anyVertices(count, 20.0f);
        LightInSpace atOnce(1.5);
        LightInSpace single(1.5);
        for (int twice = 0; twice < 2; ++twice) {
            atOnce.addAll(eyeMm, met);
            for (const shared::PrimaryVertex& vertex : met) {
                const glm::dvec3 way(vertex.fromEyeMm);
                if (way != glm::dvec3(0.0)) single.add(eyeMm + way, glm::normalize(way), vertex.radiance);
            }
        }
        atOnce.finish();
        single.finish();
        ASSERT_EQ(atOnce.cells(), single.cells());
        for (std::size_t t = 0; t < LightInSpace::kTables; ++t) {
            const auto ours = atOnce.cellsOf(t);
            const auto right = single.cellsOf(t);
            ASSERT_EQ(ours.size(), right.size());
            if (!ours.empty()) {
                EXPECT_EQ(std::memcmp(ours.data(), right.data(), ours.size_bytes()), 0);
            }
        }
    }
    LightInSpace few(1.0, 60);
    few.addAll(eyeMm, anyVertices(20000, 16.0f));
    EXPECT_LE(few.cells(), 60u);
    EXPECT_EQ(few.cellMm(), std::exp2(std::round(std::log2(few.cellMm()))));
    few.finish();
    EXPECT_NEAR(few.at(eyeMm, {0, 1, 0})->x, 1.0, 1e-4);
}

// Larger cells, and the light of all that were put together.
TEST(LightInSpace, GrowsNoLargerThanItMay) {
    std::mt19937 random(3);
    LightInSpace light(1.0, 100);
    for (int i = 0; i < 30000; ++i) {
        const glm::dvec3 at = anyPlace(random, -16.0, 16.0);
        light.add(at, anyDirection(random), glm::vec3(at.x < 0.0 ? 1.0f : 5.0f));
        ASSERT_LE(light.cells(), 100u);
    }
    EXPECT_EQ(light.cellMm(), 8.0);
    EXPECT_EQ(light.cells(), 64u);
    light.finish();
    EXPECT_NEAR(light.at({-12.0, 4.0, 4.0}, {0, 1, 0})->x, 1.0, 0.02);
    EXPECT_NEAR(light.at({12.0, 4.0, 4.0}, {0, 1, 0})->x, 5.0, 0.1);
}

}  // namespace
}  // namespace macula::hybrid
