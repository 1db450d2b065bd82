// Masks on the grid of a volume.
#include <gtest/gtest.h>

#include "pipeline/volume/clip_bricks.h"
#include "pipeline/volume/mask_bits.h"
#include "trace/scenes.h"

namespace macula {
namespace {

std::shared_ptr<const LabelMap> labels(glm::ivec3 size, const glm::dmat4& worldFromVoxel,
                                       const std::function<std::uint16_t(int, int, int)>& label) {
    std::vector<std::uint16_t> all;
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) all.push_back(label(i, j, k));
        }
    }
    return std::make_shared<const LabelMap>(
        std::move(LabelMap::create(size, worldFromVoxel,
                                   {{.number = 1, .label = "a"}, {.number = 2, .label = "b"}},
                                   std::move(all)))
            .value());
}

const glm::dmat4 kGrid = affine({0.8, 0, 0}, {0, 1.1, 0.2}, {0, -0.3, 2.5}, {40, -70, 300});

std::shared_ptr<const Volume> volume() {
    return scenes::volumeOf({37, 29, 21}, kGrid, [](int, int, int) { return std::uint16_t(1); });
}

TEST(MaskBits, KeepsOrHidesTheSegmentsNamed) {
    const auto map = labels({37, 29, 21}, kGrid,
                            [](int i, int j, int k) { return std::uint16_t((i + 2 * j + 3 * k) % 4); });
    for (const bool outside : {false, true}) {
        for (const std::vector<std::uint16_t>& numbers : {std::vector<std::uint16_t>{}, {2}, {1, 3}}) {
            const MaskBits bits = maskBits({map, numbers, outside ? Keep::outside : Keep::inside}, *volume());
            for (int k = 0; k < 21; ++k) {
                for (int j = 0; j < 29; ++j) {
                    for (int i = 0; i < 37; ++i) {
                        const std::uint16_t label = map->label(i, j, k);
                        const bool in = numbers.empty()
                                            ? label != 0
                                            : std::count(numbers.begin(), numbers.end(), label) > 0;
                        ASSERT_EQ(bits.shows(i, j, k), in != outside) << i << ' ' << j << ' ' << k;
                    }
                }
            }
        }
    }
}

// Twice as fine, shifted, and smaller than the volume.
TEST(MaskBits, AnotherGridIsReadWhereItIs) {
    const glm::dmat4 fine = kGrid * affine({0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {4, 5, 6});
    const auto map =
        labels({20, 20, 20}, fine, [](int i, int, int) { return std::uint16_t(i < 10 ? 1 : 2); });
    const MaskBits bits = maskBits({map, {1}, Keep::inside}, *volume());
    for (int i = 0; i < 37; ++i) {
        EXPECT_EQ(bits.shows(i, 9, 10), i >= 4 && i < 9) << i;  // label voxel 2 (i - 4)
        EXPECT_FALSE(bits.shows(i, 2, 10));
        EXPECT_FALSE(bits.shows(i, 9, 20));
    }
}

TEST(MaskBits, BricksAreEmptyOnlyWhenNothingOfThemIsShown) {
    const auto v = volume();
    const auto map = labels({37, 29, 21}, kGrid, [](int i, int j, int k) {
        return std::uint16_t(i == 7 && j == 20 && k == 3 ? 1 : 0);
    });
    const MaskBits bits = maskBits({map, {}, Keep::inside}, *v);
    const BrickGrid grid = makeBrickGrid(*v);
    const Medium medium = makeMedium(*v, grid, scenes::homogeneous(1.0), {}, &bits);
    // Voxel 7 is the last of block 0, and both bricks 0 and 1 reach it.
    for (int z = 0; z < grid.size.z; ++z) {
        for (int y = 0; y < grid.size.y; ++y) {
            for (int x = 0; x < grid.size.x; ++x)
                EXPECT_EQ(medium.bounds[grid.index(x, y, z)] > 0.0f, x <= 1 && y == 2 && z == 0)
                    << x << y << z;
        }
    }
    // Where what is removed casts shadow, light still meets it.
    Clip clip;
    clip.removedCastsShadow = true;
    EXPECT_EQ(makeMedium(*v, grid, scenes::homogeneous(1.0), clip, &bits).visibleBricks(),
              makeMedium(*v, grid, scenes::homogeneous(1.0)).visibleBricks());
}

}  // namespace
}  // namespace macula
