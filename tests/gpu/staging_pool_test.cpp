// Bytes on their way to a device whose memory the host does not see, and back.
#include "pipeline/gpu/staging_pool.h"

#include <cstring>
#include <numeric>
#include <vector>

#include "gpu/gpu_test.h"
#include "gpu/lose_device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/test_gpu.h"

namespace macula::gpu {
namespace {

std::vector<std::uint32_t> countingFrom(std::uint32_t first, std::size_t count) {
    std::vector<std::uint32_t> values(count);
    std::iota(values.begin(), values.end(), first);
    return values;
}

class StagingPoolTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        card_ = expectOk(Device::create(*instance_, {.separateMemory = true, .isAnnounced = false}));
    }
    void TearDown() override {
        card_.reset();  // what it forgot to free is a message of the validation layer
        GpuTest::TearDown();
    }
    Buffer local(std::uint64_t bytes) {
        Buffer made = expectOk(Buffer::create(card_, {.label = "local", .bytes = bytes}));
        EXPECT_TRUE(made.mapped().empty());
        return made;
    }

    std::shared_ptr<Device> card_;
};

TEST_F(StagingPoolTest, ManyReadsAndUploadsTakeAFewBuffers) {
    const Buffer buffer = local(40'000);
    const Image image = expectOk(Image::create(card_, {.label = "image", .width = 64, .height = 32}));
    for (std::uint32_t i = 0; i < 60; ++i) {
        // Sizes and places change, so that what a larger one left behind would be seen.
        const auto values = countingFrom(1000 * i, 1 + 163 * i);
        expectOk(uploadTo(buffer, 4 * (i % 3), std::as_bytes(std::span(values))));
        const auto read = expectOk(readBytes(buffer, 4 * (i % 3), 4 * values.size()));
        EXPECT_EQ(std::memcmp(read.data(), values.data(), read.size()), 0) << i;
        const std::vector<std::byte> pixels(image.bytes(), std::byte(i));
        expectOk(uploadTo(image, pixels));
        EXPECT_EQ(expectOk(readBytes(image)), pixels) << i;
    }
    EXPECT_LE(card_->staging().made(), 2 * StagingPool::kMostOfAKind);
    EXPECT_LE(card_->staging().kept(), 2 * StagingPool::kMostOfAKind);
}

// Nothing waits between them: what is still being copied is not written over.
TEST_F(StagingPoolTest, UploadsInFlightKeepTheirBytes) {
    constexpr std::uint32_t kCount = 1u << 14;
    const Kernel kernel = expectOk(Kernel::create(card_, shaders::slow_comp));
    const Buffer source = local(kCount * 4);
    const Buffer result = local(kCount * 4);
    auto recorder = expectOk(Recorder::create(card_, "slow"));
    recorder.fill(source, 1);
    recorder.dispatch(kernel, {kCount}, std::uint32_t{20'000}, {source, result});
    static_cast<void>(expectOk(recorder.submit()));
    std::vector<Buffer> buffers;
    for (std::uint32_t i = 0; i < 12; ++i) buffers.push_back(local(4000));
    for (std::uint32_t i = 0; i < 12; ++i)
        expectOk(uploadTo<std::uint32_t>(buffers[i], countingFrom(i << 16, 1000)));
    for (std::uint32_t i = 0; i < 12; ++i)
        EXPECT_EQ(expectOk(read<std::uint32_t>(buffers[i])), countingFrom(i << 16, 1000)) << i;
    EXPECT_LE(card_->staging().kept(), 2 * StagingPool::kMostOfAKind);
}

TEST_F(StagingPoolTest, MoreThanAChunkGoesInTwoBuffers) {
    const std::size_t count = 5 * StagingPool::kMostBytes / 8 + 3;  // two and a half chunks
    const Buffer buffer = local(4 * count);
    const auto values = countingFrom(7, count);
    expectOk(uploadTo<std::uint32_t>(buffer, values));
    EXPECT_EQ(card_->staging().made(), 2u);
    EXPECT_EQ(expectOk(read<std::uint32_t>(buffer)), values);
    EXPECT_EQ(card_->staging().made(), 3u);
    expectOk(uploadTo<std::uint32_t>(buffer, values));
    EXPECT_EQ(expectOk(read<std::uint32_t>(buffer)), values);
    EXPECT_EQ(card_->staging().made(), 3u);
}

TEST_F(StagingPoolTest, WhatIsTooLargeIsNotKept) {
    StagingPool& pool = card_->staging();
    {
        const auto large = Staging::take(card_, MemoryKind::upload, StagingPool::kMostBytes + 1);
        ASSERT_TRUE(large.ok());
        EXPECT_EQ(large->buffer().bytes(), StagingPool::kMostBytes + 1);
    }
    EXPECT_EQ(pool.kept(), 0u);
    { ASSERT_TRUE(Staging::take(card_, MemoryKind::upload, 1).ok()); }
    EXPECT_EQ(pool.kept(), 1u);
    pool.clear(card_);
    EXPECT_EQ(pool.kept(), 0u);
}

TEST_F(StagingPoolTest, TheSmallestGoesFirst) {
    StagingPool& pool = card_->staging();
    {
        std::vector<Staging> taken;
        for (std::uint64_t bytes = 64u << 10; bytes <= 1u << 20; bytes *= 2)  // five
            taken.push_back(*Staging::take(card_, MemoryKind::readback, bytes));
    }
    EXPECT_EQ(pool.kept(), StagingPool::kMostOfAKind);
    const std::uint64_t made = pool.made();
    const auto small = Staging::take(card_, MemoryKind::readback, 1);
    ASSERT_TRUE(small.ok());
    EXPECT_EQ(pool.made(), made) << "a larger one serves";
    EXPECT_EQ(small->buffer().bytes(), 128u << 10);
    const auto other = Staging::take(card_, MemoryKind::upload, 1);
    ASSERT_TRUE(other.ok());
    EXPECT_EQ(pool.made(), made + 1) << "those of the other kind do not";
}

// Where the host's memory is the device's.
TEST_F(StagingPoolTest, GivesWayWhereMemoryIsShort) {
    if (!device()->hasUnifiedMemory()) GTEST_SKIP() << "the device has memory of its own";
    { ASSERT_TRUE(Staging::take(device(), MemoryKind::readback, 1000).ok()); }
    ASSERT_EQ(device()->staging().kept(), 1u);
    {
        const test::NoMemory full;
        EXPECT_FALSE(Buffer::create(device(), {.label = "more", .bytes = 1u << 20}).ok());
    }
    EXPECT_EQ(device()->staging().kept(), 0u);
}

// What was computed comes back though there is memory for nothing more.
TEST_F(StagingPoolTest, ResultsAreReadThroughWhatIsLeft) {
    const Buffer large = local(400'000);
    const Buffer small = local(64);
    const auto values = countingFrom(5, 100'000);
    expectOk(uploadTo<std::uint32_t>(large, values));
    expectOk(uploadTo<std::uint32_t>(small, countingFrom(0, 16)));
    EXPECT_EQ(expectOk(read<std::uint32_t>(small)), countingFrom(0, 16));
    {
        const test::NoMemory full;
        EXPECT_EQ(expectOk(read<std::uint32_t>(large)), values) << "in portions";
        EXPECT_GT(full.refused(), 0);
    }
    card_->staging().clear(card_);
    {
        const test::NoMemory full(100'000);
        EXPECT_EQ(expectOk(read<std::uint32_t>(large)), values) << "in small portions";
    }
    card_->staging().clear(card_);
    expectOk(card_->waitForAll());
    const test::NoMemory full;
    const auto none = read<std::uint32_t>(large);
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().code, ErrorCode::outOfMemory);
}

// A pool that held its device would keep it for ever.
TEST_F(StagingPoolTest, DoesNotKeepItsDevice) {
    const std::weak_ptr<Device> watched = card_;
    {
        const Buffer buffer = local(64);
        expectOk(uploadTo<std::uint32_t>(buffer, countingFrom(0, 16)));
        EXPECT_EQ(expectOk(read<std::uint32_t>(buffer)), countingFrom(0, 16));
    }
    EXPECT_GT(card_->staging().kept(), 0u);
    card_.reset();
    EXPECT_TRUE(watched.expired());
}

TEST_F(StagingPoolTest, OfALostDeviceGivesNoMore) {
    const Buffer buffer = local(64);
    expectOk(uploadTo<std::uint32_t>(buffer, countingFrom(0, 16)));
    test::loseDeviceAt(test::VulkanCall::wait, 1);
    EXPECT_FALSE(card_->waitForAll().ok());
    test::loseDeviceAt(test::VulkanCall::wait, 1, 0);
    ASSERT_TRUE(card_->lost());
    ASSERT_GT(card_->staging().kept(), 0u);
    const auto none = Staging::take(card_, MemoryKind::upload, 16);
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().code, ErrorCode::deviceLost);
    card_->staging().clear(card_);
}

}  // namespace
}  // namespace macula::gpu
