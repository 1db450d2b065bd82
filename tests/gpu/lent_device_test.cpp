// A device that a host has made, and keeps.
#include <gtest/gtest.h>

#include <mutex>
#include <numeric>
#include <thread>

#include "gpu/gpu_test.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"

namespace macula::gpu {
namespace {

class HostsGuard final : public QueueGuard {
  public:
    void lock() override { mutex_.lock(); }
    void unlock() override { mutex_.unlock(); }
    bool isFree() {
        const bool taken = mutex_.try_lock();
        if (taken) mutex_.unlock();
        return taken;
    }

  private:
    std::mutex mutex_;
};

// The fixture's own device is the host's.
class LentDeviceTest : public GpuTest {
  protected:
    Instance borrowed() {
        return expectOk(Instance::create({.extensions = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME},
                                          .validation = Validation::off,
                                          .createInstance = {},
                                          .lent = instance_->handle()}));
    }
    std::shared_ptr<Device> lent(const Instance& instance) {
        DeviceOptions options;
        options.physical = device()->physical();
        options.lent = LentDevice{.handle = device()->handle(),
                                  .queue = device()->queue(),
                                  .queueFamily = device()->queueFamily(),
                                  .guard = guard_};
        return expectOk(Device::create(instance, options));
    }
    static void expectWorks(const std::shared_ptr<Device>& device) {
        std::vector<std::uint32_t> values(64);
        std::iota(values.begin(), values.end(), 7u);
        const Buffer from = expectOk(Buffer::create(device, {.label = "from", .bytes = 256}));
        const Buffer to = expectOk(Buffer::create(device, {.label = "to", .bytes = 256}));
        expectOk(uploadTo(from, std::span<const std::uint32_t>(values)));
        auto recorder = expectOk(Recorder::create(device, "copy"));
        recorder.copy(from, 0, to, 0, 256);
        static_cast<void>(expectOk(recorder.submit()));
        EXPECT_EQ(expectOk(read<std::uint32_t>(to)), values);
    }

    std::shared_ptr<HostsGuard> guard_ = std::make_shared<HostsGuard>();
};

TEST_F(LentDeviceTest, WorksAndIsLeftToItsHost) {
    {
        const Instance instance = borrowed();
        EXPECT_EQ(instance.handle(), instance_->handle());
        const std::shared_ptr<Device> guest = lent(instance);
        EXPECT_EQ(guest->handle(), device()->handle());
        expectWorks(guest);
        expectWorks(device());
        EXPECT_TRUE(guard_->isFree());
    }
    expectWorks(device());  // the guest is gone
    expectWorks(lent(borrowed()));
}

TEST_F(LentDeviceTest, WaitsWhileTheHostUsesTheQueue) {
    const std::shared_ptr<Device> guest = lent(borrowed());
    auto recorder = expectOk(Recorder::create(guest, "nothing"));
    std::atomic<bool> isSubmitted = false;
    guard_->lock();
    std::thread other([&] {
        EXPECT_TRUE(recorder.submit().ok());
        isSubmitted = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_FALSE(isSubmitted);
    guard_->unlock();
    other.join();
    EXPECT_TRUE(isSubmitted);
}

// Its host may hold the queue for long: what is on it may wait for the host.
TEST_F(LentDeviceTest, IsGivenBackWhileTheHostUsesTheQueue) {
    std::shared_ptr<Device> guest = lent(borrowed());
    expectWorks(guest);
    guard_->lock();
    std::atomic<bool> isGivenBack = false;
    std::thread other([&] {
        guest.reset();
        isGivenBack = true;
    });
    for (int i = 0; i < 500 && !isGivenBack; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(isGivenBack);
    guard_->unlock();
    other.join();
}

TEST_F(LentDeviceTest, AQueueOfAFamilyThatIsNoneIsRefused) {
    DeviceOptions options;
    options.physical = device()->physical();
    options.lent = LentDevice{.handle = device()->handle(), .queue = device()->queue(), .queueFamily = 1000};
    const auto refused = Device::create(borrowed(), options);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
}

TEST_F(LentDeviceTest, ADeviceThatIsNoneIsRefused) {
    DeviceOptions options;
    options.physical = device()->physical();
    options.lent = LentDevice{};
    const auto refused = Device::create(borrowed(), options);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::deviceNotUsable);
}

// A part of a picture, bit by bit, into a layer of an sRGB image of somebody else.
TEST_F(LentDeviceTest, APartIsCopiedToALayerOfAnotherImage) {
    const Image from = expectOk(Image::create(
        device(), {.label = "from", .width = 8, .height = 6, .format = VK_FORMAT_R8G8B8A8_UNORM}));
    std::vector<std::uint32_t> pixels(48);
    std::iota(pixels.begin(), pixels.end(), 0x40302010u);
    expectOk(uploadTo(from, std::as_bytes(std::span(pixels))));

    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = VK_FORMAT_R8G8B8A8_SRGB;
    info.extent = {4, 3, 1};
    info.mipLevels = 1;
    info.arrayLayers = 2;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                 VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    VkImage theirs = VK_NULL_HANDLE;
    ASSERT_EQ(vkCreateImage(device()->handle(), &info, nullptr, &theirs), VK_SUCCESS);
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device()->handle(), theirs, &needs);
    VkMemoryAllocateInfo allocation{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    allocation.allocationSize = needs.size;
    while (!(needs.memoryTypeBits & (1u << allocation.memoryTypeIndex))) ++allocation.memoryTypeIndex;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    ASSERT_EQ(vkAllocateMemory(device()->handle(), &allocation, nullptr, &memory), VK_SUCCESS);
    ASSERT_EQ(vkBindImageMemory(device()->handle(), theirs, memory, 0), VK_SUCCESS);

    const Buffer read = expectOk(Buffer::create(device(), {.label = "read", .bytes = 48}));
    auto recorder = expectOk(Recorder::create(device(), "copy"));
    recorder.copy(from, {{3, 2}, {4, 3}},
                  {.image = theirs, .layer = 1, .layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL});
    recorder.barrier();
    const VkBufferImageCopy back{0, 0, 0, {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 1}, {0, 0, 0}, {4, 3, 1}};
    vkCmdCopyImageToBuffer(recorder.commands(), theirs, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, read.handle(),
                           1, &back);
    recorder.barrier();
    static_cast<void>(expectOk(recorder.submit()));
    const auto got = expectOk(gpu::read<std::uint32_t>(read));
    for (std::size_t y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 4; ++x)
            EXPECT_EQ(got[y * 4 + x], pixels[(y + 2) * 8 + x + 3]) << x << " " << y;
    expectOk(device()->waitForAll());
    vkDestroyImage(device()->handle(), theirs, nullptr);
    vkFreeMemory(device()->handle(), memory, nullptr);
}

}  // namespace
}  // namespace macula::gpu
