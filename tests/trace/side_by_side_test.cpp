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
    for (const std::uint32_t blocks : {1u, kFovea, kFrame, kLargest}) {
        EXPECT_FALSE(cpu.isFor(blocks));
        EXPECT_EQ(cpu.threadsPerPixel(blocks, 16), 1u);
    }
}

TEST(SideBySide, ASmallPictureOnACardTakesTheThreadsThatThereAre) {
    const SideBySide card(kLargeCard);
    EXPECT_EQ(card.blocksAtOnce(), 4224u);
    EXPECT_TRUE(card.isFor(kFovea));
    EXPECT_EQ(card.threadsPerPixel(kFovea, 1), 1u);
    EXPECT_EQ(card.threadsPerPixel(kFovea, 4), 4u);
    // There is room for seven: three rounds, and no thread has less to do than a round less than the others.
    EXPECT_EQ(card.threadsPerPixel(kFovea, 16), 6u);
    // All of a whole frame keeps the card busy by itself.
    EXPECT_FALSE(card.isFor(kFrame));
    EXPECT_EQ(card.threadsPerPixel(kFrame, 16), 1u);
}

// Whatever the picture: never more threads than the device holds, nor one without a sample, and the longest
// row is as short as it can be.
TEST(SideBySide, NoThreadIsInVain) {
    for (const std::uint32_t held : {0u, 1u, 63u, 64u, 8192u, 65536u, kLargeCard, 1u << 24}) {
        const SideBySide device(held);
        for (const std::uint32_t blocks : {0u, 1u, 2u, 63u, kFovea, 2112u, 2113u, 4224u, kFrame, kLargest}) {
            for (const std::uint32_t samples : {0u, 1u, 2u, 3u, 7u, 16u, 1000u}) {
                const std::uint32_t threads = device.threadsPerPixel(blocks, samples);
                ASSERT_GE(threads, 1u);
                ASSERT_LE(threads, std::max(samples, 1u));
                if (threads > 1) {
                    ASSERT_LE(std::uint64_t(threads) * blocks, std::max(device.blocksAtOnce(), 1u));
                    ASSERT_TRUE(device.isFor(blocks));
                    const std::uint32_t row = (samples + threads - 1) / threads;
                    ASSERT_LT(std::uint64_t(threads - 1) * row, samples) << "one thread fewer would do";
                }
            }
        }
    }
}

TEST(SideBySide, APassFitsWhatMayBeKept) {
    const SideBySide card(kLargeCard);
    EXPECT_EQ(card.mostSamples(kFovea, 8), 7u * 8u);
    EXPECT_EQ(card.mostSamples(kFovea, 64), SideBySide::kMostBlockSamples / kFovea);
    EXPECT_EQ(card.mostSamples(kLargest, 8), 1u);
    for (const std::uint32_t blocks : {1u, 2u, 63u, kFovea, 2112u}) {
        const std::uint64_t most = card.mostSamples(blocks, 64);
        EXPECT_GE(most, 1u);
        EXPECT_LE(most * blocks, SideBySide::kMostBlockSamples);
    }
}

TEST(SideBySide, MayBeForced) {
    SideBySide cpu(0);
    cpu.force(4);
    EXPECT_TRUE(cpu.isFor(kFrame));
    EXPECT_EQ(cpu.threadsPerPixel(kFrame, 16), 4u);
    EXPECT_EQ(cpu.threadsPerPixel(kFrame, 3), 3u);
    EXPECT_EQ(cpu.threadsPerPixel(kFrame, 5), 3u);  // two each, and one
    cpu.force(1);                                   // the kernel, with one thread for a pixel
    EXPECT_TRUE(cpu.isFor(kFrame));
    EXPECT_EQ(cpu.threadsPerPixel(kFrame, 16), 1u);
    cpu.force(0);
    EXPECT_FALSE(cpu.isFor(kFrame));
}

}  // namespace
}  // namespace macula::trace
