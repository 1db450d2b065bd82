// What a hosted picture shares with another device, and what it keeps of that.
#include "live/hosted/host_picture.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <numeric>
#include <span>

#include "gpu/gpu_test.h"
#include "host_share.h"
#include "pipeline/gpu/physical_device.h"
#include "pipeline/gpu/transfer.h"

namespace macula::live {
namespace {

using gpu::expectOk;

constexpr std::uint32_t kSide = 16;

class HostPictureTest : public gpu::GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (!gpu::hasExtension(device()->physical(), VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME))
            GTEST_SKIP() << "the device shares no memory";
        const gpu::CardIdentity card = gpu::identityOf(*device());
        const char* what = "";
        ASSERT_TRUE(host_open_on(&host_, kSide, kSide, card.device.data(), card.driver.data(), &what))
            << what;
        ASSERT_TRUE(host_share_image(&host_, &made_));
        const int descriptor = host_memory_fd(&host_);
        target_ = std::make_shared<const gpu::SharedMemory>(
            expectOk(gpu::SharedMemory::create(described(descriptor))));
        close(descriptor);
    }
    void TearDown() override {
        picture_->leaveDevice();
        target_.reset();
        host_close(&host_);
        GpuTest::TearDown();
    }

    gpu::SharedMemoryHandles described(int descriptor) {
        gpu::SharedMemoryHandles options;
        options.memory = descriptor;
        options.card = gpu::identityOf(*device());
        options.bytes = made_.bytes;
        options.memoryType = made_.memory_type;
        options.isDedicated = made_.is_dedicated != 0;
        options.width = options.height = kSide;
        options.format = made_.format;
        options.usage = made_.usage;
        options.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        return options;
    }
    static std::vector<std::uint32_t> pixels(std::uint32_t side, std::uint32_t first) {
        std::vector<std::uint32_t> made(std::size_t(side) * side);
        std::iota(made.begin(), made.end(), first);
        return made;
    }
    void show(const std::shared_ptr<gpu::Device>& device, std::uint32_t side, std::uint32_t first) {
        const gpu::Image image = expectOk(gpu::Image::create(
            device, {.label = "shown", .width = side, .height = side, .format = VK_FORMAT_R8G8B8A8_UNORM}));
        const std::vector<std::uint32_t> made = pixels(side, first);
        expectOk(gpu::uploadTo(image, std::as_bytes(std::span(made))));
        expectOk(picture_->keep(device, image));
    }
    std::vector<std::uint32_t> hostHas() {
        const std::uint8_t* found = host_pixels(&host_);
        if (found == nullptr) return {};
        std::vector<std::uint32_t> read(std::size_t(kSide) * kSide);
        std::memcpy(read.data(), found, 4 * read.size());
        host_unmap(&host_);
        return read;
    }

    std::shared_ptr<HostPicture> picture_ = std::make_shared<HostPicture>();
    host_device host_{};
    host_share made_{VK_FORMAT_R8G8B8A8_UNORM,
                     VK_IMAGE_TILING_OPTIMAL,
                     VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                     1,
                     0,
                     0,
                     0};
    std::shared_ptr<const gpu::SharedMemory> target_;
};

TEST_F(HostPictureTest, NothingIsSharedBeforeThereIsAPicture) {
    EXPECT_FALSE(expectOk(picture_->shareTo(target_)));
    show(device(), kSide, 5);
    EXPECT_TRUE(expectOk(picture_->shareTo(target_)));
    EXPECT_EQ(hostHas(), pixels(kSide, 5));
}

// Pixels are repeated, as in memory.
TEST_F(HostPictureTest, ASmallerPictureFillsTheSharedImage) {
    show(device(), kSide / 2, 77);
    EXPECT_TRUE(expectOk(picture_->shareTo(target_)));
    std::vector<std::uint32_t> inMemory(std::size_t(kSide) * kSide);
    ASSERT_TRUE(expectOk(
        picture_->writeTo(reinterpret_cast<std::uint8_t*>(inMemory.data()), 4 * kSide, {kSide, kSide})));
    EXPECT_EQ(hostHas(), inMemory);
    EXPECT_EQ(inMemory[0], inMemory[kSide + 1]);
}

// As after a loss: what was imported goes with the device, and another one imports it again.
TEST_F(HostPictureTest, AnotherDeviceImportsItAgain) {
    auto first = expectOk(gpu::Device::create(*instance_));
    const std::weak_ptr<gpu::Device> gone = first;
    auto screen = expectOk(placeOf(picture_)->open(first, {kSide, kSide}));
    show(first, kSide, 1);
    EXPECT_TRUE(expectOk(picture_->shareTo(target_)));
    EXPECT_TRUE(expectOk(picture_->shareTo(target_)));
    EXPECT_EQ(hostHas(), pixels(kSide, 1));
    screen.reset();
    EXPECT_FALSE(expectOk(picture_->shareTo(target_)));
    first.reset();
    EXPECT_TRUE(gone.expired()) << "something stays on a device that is given up";
    show(device(), kSide, 1000);
    EXPECT_TRUE(expectOk(picture_->shareTo(target_)));
    EXPECT_EQ(hostHas(), pixels(kSide, 1000));
}

// Its host has closed it: nothing of it stays once another one is shared.
TEST_F(HostPictureTest, WhatIsNoLongerSharedIsLetGo) {
    show(device(), kSide, 1);
    EXPECT_TRUE(expectOk(picture_->shareTo(target_)));
    expectOk(device()->waitForAll());
    const std::size_t before = device()->pendingDestructions();
    target_ = std::make_shared<const gpu::SharedMemory>(
        expectOk(gpu::SharedMemory::create(described(target_->memory().get()))));
    // While one is open, nothing that was dropped is destroyed.
    const gpu::Recorder holding = expectOk(gpu::Recorder::create(device(), "holds what is dropped"));
    EXPECT_TRUE(expectOk(picture_->shareTo(target_)));
    EXPECT_EQ(device()->pendingDestructions(), before + 2) << "an image, and its memory";
    EXPECT_TRUE(expectOk(picture_->shareTo(target_)));
    EXPECT_EQ(device()->pendingDestructions(), before + 2) << "it is imported once";
    EXPECT_EQ(hostHas(), pixels(kSide, 1));
}

}  // namespace
}  // namespace macula::live
