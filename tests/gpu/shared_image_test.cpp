// Images of another device of the same card: of a host in C, which has its own instance.
#include "pipeline/gpu/shared_image.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "gpu/gpu_test.h"
#include "gpu/lose_device.h"
#include "host_share.h"
#include "pipeline/gpu/physical_device.h"
#include "pipeline/gpu/transfer.h"

namespace macula::gpu {
namespace {

constexpr std::uint32_t kWidth = 48;
constexpr std::uint32_t kHeight = 20;
constexpr VkImageUsageFlags kUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

class SharedImageTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (!hasExtension(device()->physical(), VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME))
            GTEST_SKIP() << "the device shares no memory";
        const CardIdentity card = identityOf(*device());
        const char* what = "";
        ASSERT_TRUE(host_open_on(&host_, kWidth, kHeight, card.device.data(), card.driver.data(), &what))
            << what;
    }
    void TearDown() override {
        for (const int descriptor : descriptors_) close(descriptor);
        for (VkSemaphore semaphore : {free_, full_})
            if (semaphore) vkDestroySemaphore(host_.device, semaphore, nullptr);
        host_close(&host_);
        GpuTest::TearDown();
    }

    int kept(int descriptor) {
        EXPECT_GE(descriptor, 0);
        descriptors_.push_back(descriptor);
        return descriptor;
    }
    // The host's image, made so, as it is described to Macula.
    SharedMemoryHandles shared(const host_share& request = kUsual) {
        made_ = request;
        EXPECT_TRUE(host_share_image(&host_, &made_));
        SharedMemoryHandles options;
        options.memory = kept(host_memory_fd(&host_));
        options.card = identityOf(*device());
        options.bytes = made_.bytes;
        options.offsetBytes = made_.offset;
        options.memoryType = made_.memory_type;
        options.isDedicated = made_.is_dedicated != 0;
        options.width = kWidth;
        options.height = kHeight;
        options.format = made_.format;
        options.tiling = made_.tiling;
        options.usage = made_.usage;
        options.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        return options;
    }
    // Of the description or of the import, whichever fails.
    Result<SharedImage> imported(const SharedMemoryHandles& options) {
        MACULA_TRY(const SharedMemory memory, SharedMemory::create(options));
        return SharedImage::import(device(), memory);
    }
    void expectRefused(const SharedMemoryHandles& options, ErrorCode code, const char* what) {
        const Result<SharedImage> refused = imported(options);
        ASSERT_FALSE(refused.ok()) << what;
        EXPECT_EQ(refused.error().code, code) << what << ": " << refused.error().message;
        EXPECT_NE(refused.error().message, "") << what;
        EXPECT_NE(refused.error().hint, "") << what;
    }

    static std::vector<std::uint32_t> pixels(std::uint32_t first) {
        std::vector<std::uint32_t> made(std::size_t(kWidth) * kHeight);
        std::iota(made.begin(), made.end(), first);
        return made;
    }
    static void write(const SharedImage& image, const std::vector<std::uint32_t>& values) {
        const Image from = expectOk(Image::create(
            image.device(),
            {.label = "from", .width = kWidth, .height = kHeight, .format = VK_FORMAT_R8G8B8A8_UNORM}));
        expectOk(uploadTo(from, std::as_bytes(std::span(values))));
        Recorder recorder = expectOk(Recorder::create(image.device(), "to the host"));
        recorder.copy(from, {{0, 0}, {kWidth, kHeight}}, image.layer());
        static_cast<void>(expectOk(recorder.submit(image.semaphores())));
        if (!image.signals()) expectOk(image.device()->waitForAll());
    }
    void expectHostHas(const std::vector<std::uint32_t>& values) {
        const std::uint8_t* found = host_pixels(&host_);
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(std::memcmp(found, values.data(), 4 * values.size()), 0);
        host_unmap(&host_);
    }

    static constexpr host_share kUsual{VK_FORMAT_R8G8B8A8_UNORM, VK_IMAGE_TILING_OPTIMAL, kUsage, 1, 0, 0, 0};
    host_device host_{};
    host_share made_{};
    VkSemaphore free_ = VK_NULL_HANDLE;
    VkSemaphore full_ = VK_NULL_HANDLE;
    std::vector<int> descriptors_;
};

TEST_F(SharedImageTest, WhatIsWrittenIsOnTheOtherDevice) {
    const SharedImage image = expectOk(imported(shared()));
    EXPECT_FALSE(image.signals());
    write(image, pixels(0x01020304));
    expectHostHas(pixels(0x01020304));
    write(image, pixels(0xf0e0d0c0));
    expectHostHas(pixels(0xf0e0d0c0));
}

TEST_F(SharedImageTest, BitsOfAnSrgbImageAreThoseOfThePicture) {
    host_share request = kUsual;
    request.format = VK_FORMAT_R8G8B8A8_SRGB;
    if (!host_can_share(&host_, &request)) GTEST_SKIP() << "the device shares none such";
    write(expectOk(imported(shared(request))), pixels(0x10203040));
    expectHostHas(pixels(0x10203040));
}

TEST_F(SharedImageTest, RowsMayLieOneAfterAnother) {
    host_share request = kUsual;
    request.tiling = VK_IMAGE_TILING_LINEAR;
    if (!host_can_share(&host_, &request)) GTEST_SKIP() << "the device shares none such";
    write(expectOk(imported(shared(request))), pixels(0x33221100));
    expectHostHas(pixels(0x33221100));
}

TEST_F(SharedImageTest, ItMayLieAnywhereInTheMemory) {
    host_share request = kUsual;
    request.is_dedicated = 0;
    request.offset = 5000;
    if (!host_can_share(&host_, &request)) GTEST_SKIP() << "the device shares dedicated memory only";
    const SharedMemoryHandles options = shared(request);
    if (options.isDedicated) GTEST_SKIP() << "the device wants dedicated memory";
    EXPECT_GE(options.offsetBytes, 5000u);
    write(expectOk(imported(options)), pixels(7));
    expectHostHas(pixels(7));
}

// The host may close its own at once, and a device that replaces a lost one imports once more.
TEST_F(SharedImageTest, OneMemoryIsImportedAgainAndByOthers) {
    const SharedMemory memory = expectOk(SharedMemory::create(shared()));
    for (const int descriptor : std::exchange(descriptors_, {})) close(descriptor);
    const SharedImage first = expectOk(SharedImage::import(device(), memory));
    {
        const SharedImage second = expectOk(SharedImage::import(device(), memory));
        write(second, pixels(100));
        expectHostHas(pixels(100));
    }
    write(first, pixels(200));
    expectHostHas(pixels(200));
    const auto other = expectOk(Device::create(*instance_));
    write(expectOk(SharedImage::import(other, memory)), pixels(300));
    expectHostHas(pixels(300));
    write(first, pixels(400));
    expectHostHas(pixels(400));
}

TEST_F(SharedImageTest, WhatTheHostFreesBeforeStaysUntilItIsDropped) {
    const SharedImage image = expectOk(imported(shared()));
    vkDestroyImage(host_.device, std::exchange(host_.image, {}), nullptr);
    vkFreeMemory(host_.device, std::exchange(host_.image_memory, {}), nullptr);
    write(image, pixels(1));
}

TEST_F(SharedImageTest, AnotherCardIsRefused) {
    const SharedMemoryHandles good = shared();
    SharedMemoryHandles bad = good;
    bad.card.device[3] ^= 1;
    expectRefused(bad, ErrorCode::usage, "another card");
    bad = good;
    bad.card.driver[15] ^= 0x80;
    expectRefused(bad, ErrorCode::usage, "another driver");
    bad.card = {};
    expectRefused(bad, ErrorCode::usage, "no card");
    static_cast<void>(expectOk(imported(good)));
}

TEST_F(SharedImageTest, DescriptorsThatAreNoneAreRefused) {
    SharedMemoryHandles options = shared();
    const int good = options.memory;
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    const int closed = dup(good);
    ASSERT_EQ(close(closed), 0);
    for (const int bad : {0, -1, closed, 1'000'000, ends[0]}) {
        options.memory = bad;
        expectRefused(options, ErrorCode::usage, std::to_string(bad).c_str());
    }
    options.memory = good;
    for (const int bad : {1'000'000, ends[0]}) {
        options.signal = bad;
        expectRefused(options, ErrorCode::usage, "a semaphore that is none");
        options.wait = std::exchange(options.signal, 0);
        expectRefused(options, ErrorCode::usage, "a semaphore to wait for that is none");
        options.wait = 0;
    }
    for (const int end : ends) close(end);

    std::FILE* const file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    options.memory = fileno(file);
    EXPECT_FALSE(imported(options).ok()) << "a file is no memory of a card";
    std::fclose(file);
    options.memory = good;
    write(expectOk(imported(options)), pixels(9));  // nobody has closed it
    expectHostHas(pixels(9));
}

std::ptrdiff_t openDescriptors() {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return std::distance(begin(all), end(all));
}

// Whether it was taken or refused, and however far it was read.
TEST_F(SharedImageTest, DescriptorsAreClosedWithTheirMemory) {
    SharedMemoryHandles options = shared();
    const std::ptrdiff_t before = openDescriptors();
    {
        options.wait = options.signal = options.memory;
        SharedMemory memory = expectOk(SharedMemory::create(options));
        EXPECT_EQ(openDescriptors(), before + 3);
        memory = expectOk(SharedMemory::create(options));
        EXPECT_EQ(openDescriptors(), before + 3);
        EXPECT_GT(memory.memory().get(), STDERR_FILENO);
    }
    EXPECT_EQ(openDescriptors(), before);
    options.signal = 1'000'000;
    EXPECT_FALSE(SharedMemory::create(options).ok());
    options.signal = 0;
    options.height = 0;
    EXPECT_FALSE(SharedMemory::create(options).ok());
    EXPECT_EQ(openDescriptors(), before);
}

// It takes them with success alone.
TEST_F(SharedImageTest, DescriptorsThatTheDriverDoesNotTakeAreClosed) {
    const SharedMemory memory = expectOk(SharedMemory::create(shared()));
    const auto lost = expectOk(Device::create(*instance_));
    const std::ptrdiff_t before = openDescriptors();
    {
        const test::NoMemory none;
        EXPECT_EQ(SharedImage::import(device(), memory).error().code, ErrorCode::usage);
        EXPECT_EQ(none.refused(), 1);
    }
    EXPECT_EQ(openDescriptors(), before);
    test::loseDeviceAt(test::VulkanCall::allocate, 1);
    EXPECT_EQ(SharedImage::import(lost, memory).error().code, ErrorCode::deviceLost);
    EXPECT_EQ(test::devicesLost(), 1);
    EXPECT_EQ(openDescriptors(), before);
}

TEST_F(SharedImageTest, AfterALossAnotherDeviceHasTheImageAgain) {
    const SharedMemory memory = expectOk(SharedMemory::create(shared()));
    auto lost = expectOk(Device::create(*instance_));
    std::optional<SharedImage> image = expectOk(SharedImage::import(lost, memory));
    write(*image, pixels(50));
    test::loseDeviceAt(test::VulkanCall::submit, 1);
    {
        Recorder recorder = expectOk(Recorder::create(lost, "nothing"));
        EXPECT_EQ(recorder.submit(image->semaphores()).error().code, ErrorCode::deviceLost);
    }
    EXPECT_EQ(SharedImage::import(lost, memory).error().code, ErrorCode::deviceLost);
    const std::weak_ptr<Device> gone = lost;
    image.reset();
    lost.reset();
    EXPECT_TRUE(gone.expired());
    expectHostHas(pixels(50));
    write(expectOk(SharedImage::import(device(), memory)), pixels(60));
    expectHostHas(pixels(60));
}

TEST_F(SharedImageTest, WhatDoesNotFitIsRefused) {
    const SharedMemoryHandles good = shared();
    const auto refused = [&](const char* what, const auto& change) {
        SharedMemoryHandles options = good;
        change(options);
        expectRefused(options, ErrorCode::usage, what);
    };
    refused("no bytes", [](auto& o) { o.bytes = 0; });
    refused("a byte short", [](auto& o) { --o.bytes; });
    refused("more bytes than there are", [](auto& o) { o.bytes = std::uint64_t{1} << 62; });
    refused("behind its end", [](auto& o) { o.offsetBytes = o.bytes; });
    refused("far behind its end", [](auto& o) { o.offsetBytes = UINT64_MAX; });
    refused("dedicated, and not at its beginning", [](auto& o) { o.offsetBytes = 16, o.isDedicated = true; });
    refused("at an odd byte", [](auto& o) { o.offsetBytes = 1, o.bytes += 1, o.isDedicated = false; });
    refused("dedicated, and too large", [](auto& o) { o.bytes *= 2, o.isDedicated = true; });
    refused("no such type", [](auto& o) { o.memoryType = 31; });
    refused("no type at all", [](auto& o) { o.memoryType = UINT32_MAX; });
    refused("no width", [](auto& o) { o.width = 0; });
    refused("no height", [](auto& o) { o.height = 0; });
    refused("below 0", [](auto& o) { o.width = std::uint32_t(-1); });
    refused("larger than its memory", [](auto& o) { o.height = 16384; });
    write(expectOk(imported(good)), pixels(11));
    expectHostHas(pixels(11));
}

TEST_F(SharedImageTest, ImagesOfOtherKindsAreRefused) {
    const SharedMemoryHandles good = shared();
    const auto refused = [&](const char* what, const auto& change) {
        SharedMemoryHandles options = good;
        change(options);
        expectRefused(options, ErrorCode::usage, what);
    };
    refused("no format", [](auto& o) { o.format = VK_FORMAT_UNDEFINED; });
    refused("blue first", [](auto& o) { o.format = VK_FORMAT_B8G8R8A8_UNORM; });
    refused("tiling", [](auto& o) { o.tiling = VK_IMAGE_TILING_DRM_FORMAT_MODIFIER_EXT; });
    refused("not written to", [](auto& o) { o.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT; });
    refused("for depth", [](auto& o) { o.usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT; });
    refused("sparse", [](auto& o) { o.flags = VK_IMAGE_CREATE_SPARSE_BINDING_BIT; });
    refused("no such layout", [](auto& o) { o.layout = 12345; });
    refused("left for what it is not for",
            [](auto& o) { o.layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL; });
}

// Where nobody says it, it is the layout that fits all.
TEST_F(SharedImageTest, ItIsLeftInGeneralWhereNothingElseIsAskedFor) {
    SharedMemoryHandles options = shared();
    options.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    const SharedImage image = expectOk(imported(options));
    EXPECT_EQ(image.layer().layout, VK_IMAGE_LAYOUT_GENERAL);
    write(image, pixels(3));
}

TEST_F(SharedImageTest, SemaphoresAreRefusedWhereThereAreNone) {
    if (host_.has_semaphores) GTEST_SKIP() << "the device shares semaphores";
    SharedMemoryHandles options = shared();
    options.signal = options.memory;
    expectRefused(options, ErrorCode::deviceNotUsable, "signal");
    options.wait = std::exchange(options.signal, 0);
    const Result<SharedImage> refused = imported(options);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().hint.english().find("none"), std::string::npos) << refused.error().hint;
}

TEST_F(SharedImageTest, SemaphoresPassTheImageToAndFro) {
    if (!host_.has_semaphores) GTEST_SKIP() << "the device shares no semaphores";
    SharedMemoryHandles options = shared();
    ASSERT_TRUE(host_make_semaphore(&host_, &free_));
    ASSERT_TRUE(host_make_semaphore(&host_, &full_));
    options.wait = kept(host_semaphore_fd(&host_, free_));
    options.signal = kept(host_semaphore_fd(&host_, full_));
    const SharedImage image = expectOk(imported(options));
    EXPECT_TRUE(image.signals());
    for (std::uint32_t round = 0; round < 4; ++round) {
        ASSERT_TRUE(host_submit(&host_, VK_NULL_HANDLE, free_));
        write(image, pixels(1000 * round));
        ASSERT_TRUE(host_submit(&host_, full_, VK_NULL_HANDLE));
        expectHostHas(pixels(1000 * round));
    }
}

// A device that its host has opened without what that needs.
TEST_F(SharedImageTest, ALentDeviceMayLackWhatItNeeds) {
    host_device lender{};
    const char* what = "";
    ASSERT_TRUE(host_open(&lender, 8, 8, &what)) << what;
    SharedMemoryHandles options = shared();
    {
        const Instance borrowed = expectOk(Instance::create({.extensions = {},
                                                             .validation = Validation::off,
                                                             .createInstance = {},
                                                             .lent = lender.instance}));
        DeviceOptions lent;
        lent.physical = lender.physical;
        lent.lent = LentDevice{.handle = lender.device, .queue = lender.queue, .queueFamily = lender.family};
        const auto guest = expectOk(Device::create(borrowed, lent));
        options.card = identityOf(*guest);
        const SharedMemory memory = expectOk(SharedMemory::create(options));
        const Result<SharedImage> refused = SharedImage::import(guest, memory);
        ASSERT_FALSE(refused.ok());
        EXPECT_EQ(refused.error().code, ErrorCode::deviceNotUsable) << refused.error().message;
    }
    host_close(&lender);
}

}  // namespace
}  // namespace macula::gpu
