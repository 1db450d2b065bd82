#include "base/label_map.h"

#include <gtest/gtest.h>

namespace macula {
namespace {

TEST(LabelMap, HoldsWhatItWasGiven) {
    const glm::dmat4 placed = affine({2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {5, 6, 7});
    const auto map =
        LabelMap::create({3, 2, 2}, placed, {{.number = 7, .label = "b"}, {.number = 2, .label = "a"}},
                         {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
    ASSERT_TRUE(map);
    EXPECT_EQ(map->label(0, 0, 0), 0);
    EXPECT_EQ(map->label(1, 0, 0), 1);
    EXPECT_EQ(map->label(0, 1, 0), 3);
    EXPECT_EQ(map->label(2, 1, 1), 11);
    EXPECT_EQ(map->segments().size(), 2u);
    EXPECT_EQ(map->segments()[0].number, 2);
    ASSERT_NE(map->segment(7), nullptr);
    EXPECT_EQ(map->segment(7)->label, "b");
    EXPECT_EQ(map->segment(3), nullptr);
    EXPECT_EQ(map->worldFromVoxel(), placed);
}

TEST(LabelMap, RefusesNonsense) {
    EXPECT_FALSE(LabelMap::create({0, 1, 1}, glm::dmat4(1), {}, {}));
    EXPECT_FALSE(LabelMap::create({-1, -1, 1}, glm::dmat4(1), {}, {1}));
    EXPECT_FALSE(LabelMap::create({2, 1, 1}, glm::dmat4(1), {}, {1}));
    EXPECT_FALSE(LabelMap::create({1, 1, 1}, glm::dmat4(0), {}, {1}));
    // Sizes whose product does not fit 64 bits.
    EXPECT_FALSE(LabelMap::create({1 << 30, 1 << 30, 1 << 30}, glm::dmat4(1), {}, {}));
}

}  // namespace
}  // namespace macula
