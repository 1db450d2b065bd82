// Live frames in an image of another device: the host keeps its VkDevice for itself.
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "c/c_fixture.h"
#include "host_share.h"

namespace macula::test {
namespace {

constexpr std::uint32_t kWidth = 56;
constexpr std::uint32_t kHeight = 40;

// A host's device, image and semaphores, as macula.h describes them.
class Host {
  public:
    Host(const macula_device_identity& card, std::uint32_t width, std::uint32_t height) : card_(card) {
        const char* what = "";
        EXPECT_TRUE(host_open_on(&host_, width, height, card.device_uuid, card.driver_uuid, &what)) << what;
    }
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;
    ~Host() {
        for (VkSemaphore semaphore : {free_, full_})
            if (semaphore) vkDestroySemaphore(host_.device, semaphore, nullptr);
        host_close(&host_);
    }

    bool hasSemaphores() const { return host_.has_semaphores != 0; }

    // Its descriptors are to be closed.
    macula_shared_memory makeImage() {
        host_share made{VK_FORMAT_R8G8B8A8_UNORM,
                        VK_IMAGE_TILING_OPTIMAL,
                        VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                        1,
                        0,
                        0,
                        0};
        EXPECT_TRUE(host_share_image(&host_, &made));
        auto memory = sized<macula_shared_memory>();
        memory.memory_fd = host_memory_fd(&host_);
        std::ranges::copy(card_.device_uuid, memory.device_uuid);
        std::ranges::copy(card_.driver_uuid, memory.driver_uuid);
        memory.bytes = made.bytes;
        memory.offset = made.offset;
        memory.memory_type = made.memory_type;
        memory.is_dedicated = made.is_dedicated;
        memory.width = std::int32_t(host_.width);
        memory.height = std::int32_t(host_.height);
        memory.format = made.format;
        memory.tiling = made.tiling;
        memory.usage = made.usage;
        memory.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        return memory;
    }
    void makeSemaphores(macula_shared_memory& memory) {
        ASSERT_TRUE(host_make_semaphore(&host_, &free_));
        ASSERT_TRUE(host_make_semaphore(&host_, &full_));
        memory.wait_fd = host_semaphore_fd(&host_, free_);
        memory.signal_fd = host_semaphore_fd(&host_, full_);
        ASSERT_GT(memory.wait_fd, 0);
        ASSERT_GT(memory.signal_fd, 0);
    }
    bool lend() { return host_submit(&host_, VK_NULL_HANDLE, free_) != 0; }
    bool takeBack() { return host_submit(&host_, full_, VK_NULL_HANDLE) != 0; }

    std::vector<std::uint8_t> pixels() {
        const std::uint8_t* found = host_pixels(&host_);
        if (found == nullptr) return {};
        std::vector<std::uint8_t> read(found, found + std::size_t(4) * host_.width * host_.height);
        host_unmap(&host_);
        return read;
    }

  private:
    macula_device_identity card_;
    host_device host_{};
    VkSemaphore free_ = VK_NULL_HANDLE;
    VkSemaphore full_ = VK_NULL_HANDLE;
};

void closeAll(const macula_shared_memory& memory) {
    for (const int descriptor : {memory.memory_fd, memory.wait_fd, memory.signal_fd})
        if (descriptor > 0) close(descriptor);
}

class CSharedImage : public ::testing::Test {
  protected:
    static macula_device* device() { return testDevice(); }

    void SetUp() override {
        card_ = sized<macula_device_identity>();
        ASSERT_EQ(macula_device_identify(device(), &card_), MACULA_DONE) << lastError().message;
        const auto study = TwoBalls().study();
        view_ = viewOf(study);
        ASSERT_NE(view_, nullptr);
        auto options = sized<macula_live_options>();
        options.model = MACULA_WITHOUT_MODEL;
        macula_live* live = nullptr;
        ASSERT_EQ(macula_live_open(device(), view_.get(), &options, nullptr, &live), MACULA_DONE)
            << lastError().message;
        live_.reset(live);
        frame_ = sized<macula_frame>();
        frame_.width = kWidth;
        frame_.height = kHeight;
        frame_.rgba = rgba_.data();
        frame_.bytes = rgba_.size();
    }

    // Takes the descriptors.
    static Owned<macula_shared_image> share(const macula_shared_memory& memory) {
        macula_shared_image* image = nullptr;
        EXPECT_EQ(macula_shared_image_create(&memory, &image), MACULA_DONE) << lastError().message;
        closeAll(memory);
        return Owned<macula_shared_image>(image);
    }
    macula_status draw() { return macula_live_frame(live_.get(), &frame_, nullptr, &shown_); }
    bool sees() const {
        return std::ranges::any_of(rgba_, [](std::uint8_t value) { return value > 60 && value < 255; });
    }

    macula_device_identity card_{};
    Owned<macula_view> view_;
    Owned<macula_live> live_;
    std::vector<std::uint8_t> rgba_ = std::vector<std::uint8_t>(4 * kWidth * kHeight, 7);
    macula_frame frame_{};
    macula_shown shown_ = sized<macula_shown>();
};

TEST_F(CSharedImage, FramesAreTheSameAsInMemory) {
    Host host(card_, kWidth, kHeight);
    const auto image = share(host.makeImage());
    frame_.shared = image.get();
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    EXPECT_TRUE(sees());
    EXPECT_EQ(host.pixels(), rgba_);
    macula_camera camera = shown_.camera;
    frame_.camera = &camera;
    frame_.is_moving = 1;
    for (int i = 0; i < 3; ++i) {
        camera.position_mm[0] += 30.0;
        const std::vector<std::uint8_t> before = rgba_;
        ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
        EXPECT_NE(rgba_, before);
        EXPECT_EQ(host.pixels(), rgba_);
    }
    frame_.rgba = nullptr;  // and without memory
    camera.position_mm[0] += 30.0;
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    const std::vector<std::uint8_t> alone = host.pixels();
    EXPECT_EQ(alone.size(), rgba_.size());
    EXPECT_NE(alone, rgba_) << "it has the frame before";
    frame_.shared = nullptr;  // and what is no longer asked for stays
    camera.position_mm[0] += 30.0;
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    EXPECT_EQ(host.pixels(), alone);
}

TEST_F(CSharedImage, SemaphoresPassTheImageToAndFro) {
    Host host(card_, kWidth, kHeight);
    macula_shared_memory memory = host.makeImage();
    if (!host.hasSemaphores()) {
        closeAll(memory);
        GTEST_SKIP() << "the device shares no semaphores";
    }
    host.makeSemaphores(memory);
    const auto image = share(memory);
    frame_.shared = image.get();
    for (int i = 0; i < 4; ++i) {
        ASSERT_TRUE(host.lend());
        ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
        ASSERT_TRUE(host.takeBack());
        EXPECT_EQ(host.pixels(), rgba_);
    }
}

TEST_F(CSharedImage, SemaphoresThatCannotBeHadAreToldAndFramesGoOnWithout) {
    Host host(card_, kWidth, kHeight);
    macula_shared_memory memory = host.makeImage();
    if (host.hasSemaphores()) {
        closeAll(memory);
        GTEST_SKIP() << "the device shares semaphores";
    }
    memory.signal_fd = dup(memory.memory_fd);
    const auto image = share(memory);
    frame_.shared = image.get();
    expectError(draw(), MACULA_DEVICE);
    EXPECT_NE(std::string(lastError().advice).find("when the call returns"), std::string::npos);
    frame_.shared = nullptr;
    EXPECT_EQ(draw(), MACULA_DONE) << lastError().message;
}

// A window that is resized: another image, of another size.
TEST_F(CSharedImage, OneAfterAnotherIsShared) {
    for (const std::uint32_t height : {kHeight, kHeight / 2}) {
        Host host(card_, kWidth, height);
        const auto image = share(host.makeImage());
        frame_.height = std::int32_t(height);
        frame_.shared = image.get();
        ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
        const std::vector<std::uint8_t> pixels = host.pixels();
        ASSERT_EQ(pixels.size(), std::size_t(4) * kWidth * height);
        EXPECT_TRUE(std::equal(pixels.begin(), pixels.end(), rgba_.begin()));
    }
    frame_.shared = nullptr;
    EXPECT_EQ(draw(), MACULA_DONE) << lastError().message;
}

TEST_F(CSharedImage, WhatIsNoneIsRefused) {
    Host host(card_, kWidth, kHeight);
    const macula_shared_memory good = host.makeImage();
    const auto refused = [&](const auto& change) {
        macula_shared_memory memory = good;
        change(memory);
        macula_shared_image* image = nullptr;
        expectError(macula_shared_image_create(&memory, &image), MACULA_USAGE);
        EXPECT_EQ(image, nullptr);
    };
    refused([](macula_shared_memory& m) { m.size = 0; });
    refused([](macula_shared_memory& m) { m.memory_fd = 0; });
    refused([](macula_shared_memory& m) { m.memory_fd = 1'000'000; });
    refused([](macula_shared_memory& m) { m.bytes = 0; });
    refused([](macula_shared_memory& m) { m.offset = m.bytes; });
    refused([](macula_shared_memory& m) { m.width = -1; });
    refused([](macula_shared_memory& m) { m.height = 0; });
    refused([](macula_shared_memory& m) { m.format = VK_FORMAT_B8G8R8A8_UNORM; });
    refused([](macula_shared_memory& m) { m.usage = VK_IMAGE_USAGE_SAMPLED_BIT; });
    refused([](macula_shared_memory& m) { m.layout = -1; });
    refused([](macula_shared_memory& m) { m.signal_fd = 1'000'000; });
    refused([](macula_shared_memory& m) {
        std::ranges::fill(m.device_uuid, std::uint8_t(0));
        std::ranges::fill(m.driver_uuid, std::uint8_t(0));
    });
    expectError(macula_shared_image_create(nullptr, nullptr), MACULA_USAGE);
    macula_shared_image_close(nullptr);

    frame_.width = kWidth - 1;
    const auto image = share(good);
    frame_.shared = image.get();
    expectError(draw(), MACULA_USAGE);  // not of the size of the frame
    frame_.width = kWidth;
    EXPECT_EQ(draw(), MACULA_DONE) << lastError().message;
}

TEST_F(CSharedImage, AnotherCardIsToldWithTheFrame) {
    Host host(card_, kWidth, kHeight);
    macula_shared_memory memory = host.makeImage();
    memory.device_uuid[0] ^= 1;
    const auto image = share(memory);
    frame_.shared = image.get();
    expectError(draw(), MACULA_USAGE);
    EXPECT_NE(std::string(lastError().advice).find("macula_device_identify"), std::string::npos);
    frame_.shared = nullptr;
    EXPECT_EQ(draw(), MACULA_DONE) << lastError().message;
}

// What lies behind the struct of an older header is not looked at.
TEST_F(CSharedImage, AFrameOfAnOlderHeaderHasNone) {
    frame_.size = offsetof(macula_frame, shared);
    std::memset(static_cast<void*>(&frame_.shared), 0xff, sizeof frame_.shared);
    ASSERT_EQ(draw(), MACULA_DONE) << lastError().message;
    EXPECT_TRUE(sees());
}

TEST_F(CSharedImage, ADeviceSaysWhichCardItIs) {
    EXPECT_TRUE(std::ranges::any_of(card_.device_uuid, [](std::uint8_t byte) { return byte != 0; }));
    auto again = sized<macula_device_identity>();
    ASSERT_EQ(macula_device_identify(device(), &again), MACULA_DONE);
    EXPECT_TRUE(std::ranges::equal(again.device_uuid, card_.device_uuid));
    EXPECT_TRUE(std::ranges::equal(again.driver_uuid, card_.driver_uuid));
    expectError(macula_device_identify(nullptr, &again), MACULA_USAGE);
    expectError(macula_device_identify(device(), nullptr), MACULA_USAGE);
    again.size = 1;
    expectError(macula_device_identify(device(), &again), MACULA_USAGE);
}

}  // namespace
}  // namespace macula::test
