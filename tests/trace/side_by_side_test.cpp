// How many samples of a pixel are traced side by side.
#include "pipeline/trace/side_by_side.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace macula::trace {
namespace {

constexpr std::uint32_t kLargeCard = 132 * 64 * 32;            // threads of an H100: 4224 blocks
constexpr std::uint32_t kFovea = 23 * 23;                      // blocks of 181 x 181 pixels
constexpr std::uint32_t kFrame = (1280 / 8) * (720 / 8);       // blocks
constexpr std::uint32_t kLargest = (16384 / 8) * (16384 / 8);  // blocks

TEST(SideBySide, ACpuDeviceTakesAllSamplesOfAPixelInOneThread) {
    const SideBySide cpu(0);
    EXPECT_EQ(cpu.blocksAtOnce(), 0u);
    EXPECT_EQ(cpu.leastBlocks(false, 16), 0u);
    for (const std::uint32_t blocks : {0u, 1u, kFovea, kFrame, kLargest}) EXPECT_FALSE(cpu.isFor(blocks));
}

TEST(SideBySide, ASmallPictureOnACardHasAThreadForEachSample) {
    const SideBySide card(kLargeCard);
    EXPECT_EQ(card.blocksAtOnce(), 4224u);
    EXPECT_TRUE(card.isFor(kFovea));
    EXPECT_TRUE(card.isFor(kFrame));
    EXPECT_TRUE(card.isFor(4 * 4224));
    // With one thread for each pixel it keeps the card busy for long.
    EXPECT_FALSE(card.isFor(4 * 4224 + 1));
    EXPECT_FALSE(card.isFor(kLargest));
    for (const std::uint32_t samples : {1u, 4u, 16u, 256u}) EXPECT_EQ(card.threadsPerPixel(samples), samples);
    EXPECT_EQ(card.threadsPerPixel(0), 1u);
}

// Each takes sample after sample: more than the card holds at once would only wait.
TEST(SideBySide, NoMoreThreadsThanTheCardHolds) {
    const SideBySide card(kLargeCard);
    EXPECT_EQ(card.threads(kFovea, 1), 64 * kFovea);
    EXPECT_EQ(card.threads(kFovea, 4), 64 * 4 * kFovea);
    EXPECT_EQ(card.threads(kFovea, 16), 64u * 4224u);
    EXPECT_EQ(card.threads(kFrame, 1), 64u * 4224u);
    EXPECT_EQ(SideBySide(1).threads(10, 4), 64u);
    SideBySide forced(0);
    forced.force(3);
    EXPECT_EQ(forced.threads(10, 2), 64u * 10u * 2u);
    EXPECT_EQ(forced.threads(10, 7), 64u * 10u * 3u);
}

// And the longest row is as short as it can be.
TEST(SideBySide, NoThreadIsInVain) {
    const SideBySide device(kLargeCard);
    for (const std::uint32_t samples : {0u, 1u, 2u, 7u, 255u, 256u, 257u, 300u, 512u, 513u, 100'000u}) {
        const std::uint32_t threads = device.threadsPerPixel(samples);
        ASSERT_GE(threads, 1u);
        ASSERT_LE(threads, 256u);
        const std::uint32_t row = (samples + threads - 1) / threads;
        ASSERT_EQ(row, (samples + 255) / 256);
        if (threads > 1) {
            ASSERT_LT(std::uint64_t(threads - 1) * row, samples) << "one thread fewer would do";
        }
    }
}

TEST(SideBySide, ADispatchKeepsTheCardBusyAndNotForLong) {
    const SideBySide card(kLargeCard);
    EXPECT_EQ(card.leastBlocks(false, 16), 4224u);
    EXPECT_EQ(card.leastBlocks(true, 1), 4224u);
    EXPECT_EQ(card.leastBlocks(true, 4), 4224u);
    EXPECT_EQ(card.leastBlocks(true, 16), 1056u);  // all of a fovea
    EXPECT_EQ(card.leastBlocks(true, 123), 137u);
    const SideBySide small(1);
    EXPECT_EQ(small.leastBlocks(true, 16), 0u);
    for (const std::uint32_t threads : {1u << 10, 1u << 13, 1u << 16, kLargeCard}) {
        const SideBySide device(threads);
        for (const std::uint32_t samples : {1u, 3u, 16u, 200u, 256u, 257u, 5000u}) {
            const std::uint32_t blocks = device.leastBlocks(true, samples);
            EXPECT_LE(blocks, device.blocksAtOnce());
            EXPECT_LE(blocks * device.threadsPerPixel(samples), 4 * device.blocksAtOnce()) << samples;
        }
    }
}

TEST(SideBySide, APassFitsWhatMayBeKept) {
    const SideBySide card(kLargeCard);
    EXPECT_EQ(card.mostSamples(kFovea, 64), SideBySide::kMostBlockSamples / kFovea);
    EXPECT_EQ(card.mostSamples(1, 8), 256u * 8u);
    EXPECT_EQ(card.mostSamples(kLargest, 8), 1u);
    for (const std::uint32_t blocks : {0u, 1u, 2u, 63u, kFovea, 2112u, kFrame}) {
        const std::uint64_t most = card.mostSamples(blocks, 64);
        EXPECT_GE(most, 1u);
        EXPECT_LE(most * blocks, SideBySide::kMostBlockSamples);
    }
}

TEST(SideBySide, MayBeForced) {
    SideBySide cpu(0);
    cpu.force(4);
    EXPECT_TRUE(cpu.isFor(kFrame));
    EXPECT_EQ(cpu.threadsPerPixel(16), 4u);
    EXPECT_EQ(cpu.threadsPerPixel(3), 3u);
    EXPECT_EQ(cpu.threadsPerPixel(5), 3u);  // two each, and one
    cpu.force(1);                           // the kernel, with one thread for a pixel
    EXPECT_TRUE(cpu.isFor(kFrame));
    EXPECT_EQ(cpu.threadsPerPixel(16), 1u);
    cpu.force(0);
    EXPECT_FALSE(cpu.isFor(kFrame));
}

}  // namespace
}  // namespace macula::trace
