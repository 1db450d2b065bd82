// Sets of voxels hold what was added, and nothing else.
#include "base/voxel_set.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace macula {
namespace {

using Place = std::tuple<int, int, int>;

TEST(VoxelSet, HoldsWhatWasAdded) {
    VoxelSet set({-3, 5, 7}, {130, 6, 9});
    std::set<Place> truth;
    for (int n = 0; n < 200; ++n) {
        const glm::ivec3 voxel(-3 + n * 37 % 134, 5 + n % 2, 7 + n % 3);
        set.add(voxel);
        set.add(voxel);
        truth.insert({voxel.x, voxel.y, voxel.z});
    }
    EXPECT_EQ(set.count(), truth.size());
    for (int z = 6; z <= 10; ++z) {
        for (int y = 4; y <= 7; ++y) {
            for (int x = -70; x <= 200; ++x)
                ASSERT_EQ(set.contains({x, y, z}), truth.contains({x, y, z})) << x << ' ' << y << ' ' << z;
        }
    }
    std::set<Place> visited;
    set.forEach([&](const glm::ivec3& v) { EXPECT_TRUE(visited.insert({v.x, v.y, v.z}).second); });
    EXPECT_EQ(visited, truth);
}

TEST(VoxelSet, CroppedIsTheSameInTheSmallestBox) {
    VoxelSet set({0, 0, 0}, {200, 20, 20});
    set.add({65, 3, 4});
    set.add({129, 3, 9});
    const VoxelSet small = set.cropped();
    EXPECT_EQ(small.low(), glm::ivec3(65, 3, 4));
    EXPECT_EQ(small.high(), glm::ivec3(129, 3, 9));
    EXPECT_EQ(small, set);
    EXPECT_LT(small.bytes(), set.bytes());
    EXPECT_DOUBLE_EQ(VoxelSet::bytesFor(small.low(), small.high()), double(small.bytes()));
    set.add({0, 0, 0});
    EXPECT_FALSE(small == set);
}

TEST(VoxelSet, OfNothingHasNoBox) {
    const VoxelSet none;
    EXPECT_TRUE(none.isEmpty());
    EXPECT_EQ(none.count(), 0u);
    EXPECT_FALSE(none.contains({0, 0, 0}));
    EXPECT_LT(none.high().x, none.low().x);
    const VoxelSet box({5, 5, 5}, {9, 9, 9});
    EXPECT_TRUE(box.isEmpty());
    EXPECT_EQ(box.cropped(), none);
    EXPECT_EQ(box, none);
}

TEST(VoxelSet, OfOneVoxel) {
    VoxelSet one({4, 4, 4}, {4, 4, 4});
    one.add({4, 4, 4});
    EXPECT_EQ(one.count(), 1u);
    EXPECT_TRUE(one.contains({4, 4, 4}));
    EXPECT_FALSE(one.contains({5, 4, 4}));
}

}  // namespace
}  // namespace macula
