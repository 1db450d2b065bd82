// What is kept of a volume, without a device: bricks and blocks, who needs which, levels, places in the pool.
#include "pipeline/volume/voxel_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "base/phantom.h"
#include "pipeline/trace/reference_tracer.h"
#include "pipeline/volume/block_pool.h"
#include "pipeline/volume/coarsening.h"
#include "pipeline/volume/empty_space.h"
#include "trace/scenes.h"

namespace macula {
namespace {

std::shared_ptr<const Volume> noise(glm::ivec3 size, unsigned seed) {
    std::mt19937 random(seed);
    return scenes::volumeOf(size, glm::dmat4(1.0), [&](int i, int j, int k) {
        return static_cast<std::uint16_t>(random() % 50 + unsigned(i + 3 * j + 5 * k));
    });
}

const glm::ivec3 kSizes[] = {{1, 1, 1}, {7, 8, 9}, {8, 8, 8}, {16, 24, 8}, {17, 9, 31}, {40, 33, 1}};

void expectRangesOf(const glm::ivec3& size, int reach) {
    const auto volume = noise(size, 3);
    const BrickGrid grid = makeBrickGrid(*volume, reach);
    const EntryMap map = entryMapOf(*volume);
    EXPECT_EQ(grid.size, size / 8 + 1);
    std::vector<EntryRange> bricks(grid.ranges.size(), EntryRange{0xffff, 0});
    std::vector<EntryRange> blocks(grid.blockRanges.size(), EntryRange{0xffff, 0});
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const std::uint16_t entry = map.entryOf(volume->stored(i, j, k));
                const auto join = [&](EntryRange& range) {
                    range.low = std::min(range.low, entry);
                    range.high = std::max(range.high, entry);
                };
                join(blocks[grid.blockIndex(i / 8, j / 8, k / 8)]);
                // A voxel is a corner of the cells before and after it, and is taken from up to `reach`
                // cells further: of one brick or two on each axis.
                for (int corner = 0; corner < 8; ++corner) {
                    const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
                    const glm::ivec3 at = glm::ivec3(i, j, k) + side + (2 * side - 1) * reach;
                    const glm::ivec3 brick = glm::clamp(at / 8, glm::ivec3(0), grid.size - 1);
                    join(bricks[grid.index(brick.x, brick.y, brick.z)]);
                }
            }
        }
    }
    EXPECT_EQ(grid.ranges, bricks) << size.x;
    EXPECT_EQ(grid.blockRanges, blocks) << size.x;
}

TEST(BrickGrid, RangesAreThoseOfTheVoxelsInterpolationReaches) {
    for (const glm::ivec3 size : kSizes) {
        for (const int reach : {0, 1}) expectRangesOf(size, reach);
    }
}

TEST(EmptySpace, IsTheChebyshevDistanceToTheNearestBrickWithMatter) {
    std::mt19937 random(4);
    for (const glm::ivec3 size : {glm::ivec3(1, 1, 1), {300, 1, 2}, {9, 14, 11}, {3, 40, 25}}) {
        for (const unsigned oneIn : {3u, 200u, 100000u}) {
            std::vector<float> bounds(std::size_t(size.x * size.y * size.z));
            std::vector<glm::ivec3> matter;
            const auto at = [&](int i) {
                return glm::ivec3(i % size.x, i / size.x % size.y, i / size.x / size.y);
            };
            for (int i = 0; i < int(bounds.size()); ++i) {
                if (random() % oneIn != 0) continue;
                bounds[std::size_t(i)] = 2.5f;
                matter.push_back(at(i));
            }
            measureEmptySpace(size, bounds);
            for (int i = 0; i < int(bounds.size()); ++i) {
                int nearest = kMaxLeap;
                for (const glm::ivec3& m : matter) {
                    const glm::ivec3 d = glm::abs(m - at(i));
                    nearest = std::min(nearest, std::max({d.x, d.y, d.z}));
                }
                ASSERT_EQ(bounds[std::size_t(i)], nearest == 0 ? 2.5f : -float(nearest));
            }
        }
    }
}

// The light's eye view of it: whatever is put into blocks that are not kept, nothing changes. In double, so
// that rounding at the faces of bricks does not reach across them.
TEST(VoxelBlocks, WhatIsNotKeptIsNeverSeen) {
    const glm::ivec3 size{61, 64, 43};
    const auto value = [](int i, int j, int k) {
        return std::hypot(i - 20.0, j - 33.0, k - 21.0) < 14 ? 600 + (i * 7 + j * 5 + k * 3) % 200
                                                             : (i * j + k) % 300;
    };
    const auto clean = scenes::volumeOf(size, glm::dmat4(1.0),
                                        [&](int i, int j, int k) { return std::uint16_t(value(i, j, k)); });
    TransferFunction curve = scenes::homogeneous(1.0);
    curve.opacity = {{400, 0.0}, {500, 0.3}, {750, 0.05}};
    for (const trace::Filter filter : trace::kFilters) {
        const BrickGrid grid = makeBrickGrid(*clean, trace::reachOf(filter));
        const Medium medium = makeMedium(*clean, grid, curve);
        const std::vector<std::uint8_t> shown = blocksToShow(grid, medium.bounds);
        const auto kept = std::count(shown.begin(), shown.end(), 1);
        ASSERT_GT(kept, 10);
        ASSERT_LT(double(kept), 0.7 * double(shown.size())) << "much must be left out";
        const auto poisoned = scenes::volumeOf(size, glm::dmat4(1.0), [&](int i, int j, int k) {
            return std::uint16_t(shown[grid.blockIndex(i / 8, j / 8, k / 8)] ? value(i, j, k) : 550);
        });
        ASSERT_EQ(entryMapOf(*poisoned).low, entryMapOf(*clean).low);
        const trace::Environment sky = trace::Environment::constant(glm::vec3(1.0f));
        const trace::View view{
            .camera = frameBox(clean->worldBox(), ViewDirection::left, 30, 1), .width = 40, .height = 40};
        const auto params = trace::makeTraceParams(*clean, medium, sky, view, {});
        const auto expected = trace::ReferenceTracer(*clean, medium, sky)
                                  .trace(*params, filter, trace::Precision::twofold, 0, 8);
        EXPECT_EQ(expected, trace::ReferenceTracer(*poisoned, medium, sky)
                                .trace(*params, filter, trace::Precision::twofold, 0, 8));
        glm::dvec4 sum(0.0);
        for (const glm::dvec4& pixel : expected) sum += pixel;
        EXPECT_GT(sum.a, 100.0) << "there must be something to see";
    }
}

TEST(VoxelBlocks, LevelsAreAverages) {
    const auto volume = noise({13, 8, 10}, 5);
    const EntryMap map = entryMapOf(*volume);
    for (std::uint8_t level = 0; level < kSingle; ++level) {
        std::vector<std::uint16_t> values(poolValues(level));
        writeBlock(*volume, map, {1, 0, 1}, level, values);
        const int edge = 1 << level;
        const int side = 8 / edge;
        for (int cell = 0; cell < side * side * side; ++cell) {
            const glm::ivec3 low =
                glm::ivec3(8, 0, 8) + edge * glm::ivec3(cell % side, cell / side % side, cell / side / side);
            double sum = 0.0;
            int count = 0;
            for (int v = 0; v < edge * edge * edge; ++v) {
                const glm::ivec3 at = low + glm::ivec3(v % edge, v / edge % edge, v / edge / edge);
                if (at.x >= 13 || at.y >= 8 || at.z >= 10) continue;
                sum += map.entryOf(volume->stored(at.x, at.y, at.z));
                ++count;
            }
            if (count == 0) continue;
            EXPECT_NEAR(values[std::size_t(cell)], sum / count, 0.5);
        }
    }
}

TEST(Coarsening, KeepsAllWhatFitsAndAlwaysFits) {
    const auto volume = noise({80, 72, 64}, 6);
    const BrickGrid grid = makeBrickGrid(*volume);
    const Medium medium = makeMedium(*volume, grid, scenes::homogeneous(1.0));
    const std::vector<std::uint8_t> show = blocksToShow(grid, medium.bounds);
    const auto count = static_cast<std::uint64_t>(std::count(show.begin(), show.end(), 1));
    ASSERT_EQ(count, 720u);
    std::uint64_t last = 0;
    for (const std::uint64_t slots :
         {0ul, 1ul, 5ul, 12ul, 13ul, 60ul, 90ul, 91ul, 300ul, 719ul, 720ul, 10000ul}) {
        const Coarsening fit = fitBlocks(grid, show, medium.extinctionPerMm, slots);
        std::map<std::uint8_t, std::uint64_t> blocks;
        for (const std::uint8_t level : fit.levels) ++blocks[level];
        EXPECT_EQ(blocks[kAbsent], 0u);
        EXPECT_LE(blocks[0] + (blocks[1] + 7) / 8 + (blocks[2] + 63) / 64, slots);
        EXPECT_EQ(fit.slots, blocks[0] + (blocks[1] + 7) / 8 + (blocks[2] + 63) / 64);
        EXPECT_EQ(fit.coarse, count - blocks[0]);
        EXPECT_TRUE(slots < count || fit.coarse == 0);
        EXPECT_TRUE(slots < 90 || blocks[2] + blocks[3] == 0);
        const std::uint64_t kept = blocks[0] * 512 + blocks[1] * 64 + blocks[2] * 8 + blocks[3];
        EXPECT_GE(kept, last);  // more room, more detail
        last = kept;
    }
}

TEST(Coarsening, TakesWhereLightTellsLeastApart) {
    // Blocks of values that differ by 0, 10, 20, ... along x; opaque from 1000 on.
    const auto volume = scenes::volumeOf({64, 8, 8}, glm::dmat4(1.0), [](int i, int j, int) {
        return static_cast<std::uint16_t>(i / 8 == 6 ? 1000 + j : (j % 2) * 10 * (i / 8) + 100);
    });
    TransferFunction ramp = scenes::homogeneous(1.0);
    ramp.opacity = {{50, 0.1}, {300, 0.5}, {999, 0.9}};
    const BrickGrid grid = makeBrickGrid(*volume);
    const Medium medium = makeMedium(*volume, grid, ramp);
    const std::vector<std::uint8_t> show(8, 1);
    const Coarsening fit = fitBlocks(grid, show, medium.extinctionPerMm, 5);
    // The first is one value; the seventh is equally opaque everywhere; then those that vary least.
    EXPECT_EQ(fit.levels, (std::vector<std::uint8_t>{kSingle, 1, 1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(fit.coarse, 3u);
    EXPECT_EQ(fit.slotsWanted, 7u);
}

TEST(BlockPool, PlacesNeverOverlapAndAreUsedAgain) {
    BlockPool pool;
    pool.grow(20);
    std::mt19937 random(7);
    std::vector<std::pair<std::uint8_t, std::uint32_t>> held;
    std::vector<int> owner(20 * 64, -1);  // by unit of 8 values
    const auto mark = [&](std::uint8_t level, std::uint32_t unit, int from, int to) {
        for (std::uint32_t u = unit; u < unit + poolValues(level) / 8; ++u) {
            ASSERT_EQ(owner[u], from);
            owner[u] = to;
        }
    };
    int refused = 0;
    for (int step = 0; step < 20000; ++step) {
        if (random() % 100 < 52) {
            const auto level = static_cast<std::uint8_t>(random() % 3);
            if (const auto unit = pool.allocate(level)) {
                ASSERT_EQ(*unit % (poolValues(level) / 8), 0u);
                mark(level, *unit, -1, step);
                held.emplace_back(level, *unit);
            } else {
                ++refused;
            }
        } else if (!held.empty()) {
            std::swap(held[random() % held.size()], held.back());
            const auto [level, unit] = held.back();
            mark(level, unit, owner[unit], -1);
            pool.release(level, unit);
            held.pop_back();
        }
        if (step == 10000) {
            pool.grow(25);
            owner.resize(25 * 64, -1);
        }
    }
    EXPECT_GT(refused, 100);
    for (const auto& [level, unit] : held) pool.release(level, unit);
    EXPECT_EQ(pool.freeSlots(), 25u);
    for (int i = 0; i < 25; ++i) EXPECT_TRUE(pool.allocate(0).has_value());
    EXPECT_FALSE(pool.allocate(2).has_value());
}

// On paper only: counts and positions of the largest volumes stay within 64 bits here and 31 on the device.
TEST(VoxelBlocks, GridsOfTheLargestVolumesCanBeCounted) {
    BrickGrid grid;
    grid.size = brickCount(glm::ivec3(2048));
    grid.blocks = blockCount(glm::ivec3(2048));
    EXPECT_EQ(grid.size, glm::ivec3(257));
    EXPECT_EQ(grid.blocks, glm::ivec3(256));
    EXPECT_EQ(grid.index(256, 256, 256) + 1, 16974593u);
    EXPECT_GT(16974593, 1 << 24) << "more than floats can count: the shaders must not";
    BlockPool pool;
    pool.grow(std::uint64_t{256} * 256 * 256 - 1);  // 2^33 values but 512: more than any device allows
    EXPECT_EQ(*pool.allocate(0), 0u);
    EXPECT_EQ(blockWord(2, 0x3fffffff), 0xbfffffffu);
}

}  // namespace
}  // namespace macula
