// What is left to do with a device that was lost, and how work goes on without it.
#include <chrono>
#include <cstring>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "gpu/gpu_test.h"
#include "gpu/lose_device.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/recovery.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/test_gpu.h"

namespace macula::gpu {
namespace {

using namespace std::chrono_literals;
using test::VulkanCall;

class DeviceLossTest : public GpuTest {
  protected:
    void TearDown() override {
        test::loseDeviceAt(VulkanCall::submit, 1, 0);
        if (device_ && device_->lost()) device_.reset();
        GpuTest::TearDown();
    }
    void lose() {
        test::loseDeviceAt(VulkanCall::wait, 1);
        const auto waited = device_->waitForAll();
        ASSERT_FALSE(waited.ok());
        EXPECT_EQ(waited.error().code, ErrorCode::deviceLost);
        ASSERT_TRUE(device_->lost());
    }
};

template <class T>
void expectLost(const Result<T>& result, const char* what) {
    ASSERT_FALSE(result.ok()) << what;
    EXPECT_EQ(result.error().code, ErrorCode::deviceLost) << what;
    EXPECT_FALSE(result.error().hint.empty()) << what;
}
#define EXPECT_LOST(call) expectLost(call, #call)

TEST_F(DeviceLossTest, EveryLaterCallSaysSoAndReachesTheDriverNoMore) {
    const Buffer mapped = expectOk(Buffer::create(device_, {.bytes = 64}));
    const Image image = expectOk(Image::create(device_, {.width = 4, .height = 4}));
    Recorder open = expectOk(Recorder::create(device_, "open when it was lost"));
    open.fill(mapped, 1);
    Recorder sent = expectOk(Recorder::create(device_, "sent before it was lost"));
    { const auto timed = sent.timed("fill"); }
    const Ticket ticket = expectOk(sent.submit());
    lose();

    const auto start = std::chrono::steady_clock::now();
    EXPECT_LOST(device_->waitFor(ticket, kForever));
    EXPECT_LOST(device_->waitForAll());
    EXPECT_LOST(sent.timings());
    EXPECT_LOST(open.submit());
    EXPECT_LOST(Recorder::create(device_, "after it was lost"));
    EXPECT_LOST(Buffer::create(device_, {.bytes = 64}));
    EXPECT_LOST(TexelBuffer::create(device_, {.elements = 4, .format = VK_FORMAT_R32_UINT}));
    EXPECT_LOST(Image::create(device_, {.width = 4, .height = 4}));
    EXPECT_LOST(Sampler::create(device_));
    EXPECT_LOST(Kernel::create(device_, shaders::affine_comp));
    const std::vector<std::byte> bytes(64);
    EXPECT_LOST(uploadTo(mapped, 0, bytes));
    EXPECT_LOST(uploadTo(image, std::vector<std::byte>(image.bytes())));
    EXPECT_LOST(readBytes(mapped, 0, 64));
    EXPECT_LOST(readBytes(image));
    EXPECT_EQ(device_->completedTicket(), device_->submittedTicket());
    EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);  // it is some microseconds: nothing waits
    EXPECT_EQ(test::callsOfLostDevice(), 0);
}

TEST_F(DeviceLossTest, IsNoticedWhereverItIsFirstReported) {
    struct Case {
        VulkanCall call;
        std::function<Result<void>(const std::shared_ptr<Device>&)> work;
    };
    const std::vector<Case> cases{
        {VulkanCall::submit,
         [](const auto& device) -> Result<void> {
             MACULA_TRY(Recorder recorder, Recorder::create(device, "work"));
             MACULA_TRY([[maybe_unused]] const Ticket ticket, recorder.submit());
             return {};
         }},
        {VulkanCall::wait, [](const auto& device) { return device->waitForAll(); }},
        {VulkanCall::query,
         [](const auto& device) {
             device->destroyUnused();  // tells nothing, but asks the device
             return device->waitForAll();
         }},
        {VulkanCall::allocate,
         [](const auto& device) -> Result<void> {
             MACULA_TRY([[maybe_unused]] const Buffer buffer, Buffer::create(device, {.bytes = 64}));
             return {};
         }},
        {VulkanCall::compile,
         [](const auto& device) -> Result<void> {
             MACULA_TRY([[maybe_unused]] const Kernel kernel, Kernel::create(device, shaders::affine_comp));
             return {};
         }},
    };
    for (const Case& reported : cases) {
        const auto device = expectOk(Device::create(*instance_));
        test::loseDeviceAt(reported.call, 1);
        EXPECT_LOST(reported.work(device));
        EXPECT_TRUE(device->lost());
        EXPECT_EQ(test::devicesLost(), 1);
        EXPECT_EQ(test::callsOfLostDevice(), 0);
    }
}

TEST_F(DeviceLossTest, NothingIsFreedUnderWorkThatIsStillOnItsWayOut) {
    constexpr std::uint32_t kCount = 1u << 14;
    constexpr std::uint32_t kRounds = 60'000;  // lavapipe stops at 65535, see lavapipe_test.cpp
    const Kernel slow = expectOk(Kernel::create(device_, shaders::slow_comp));
    Buffer source = expectOk(Buffer::create(device_, {.bytes = kCount * 4}));
    const Buffer result =
        expectOk(Buffer::create(device_, {.bytes = kCount * 4, .memory = MemoryKind::readback}));
    Recorder recorder = expectOk(Recorder::create(device_, "slow"));
    recorder.fill(source, 1);
    recorder.fill(result, 0);
    recorder.dispatch(slow, {kCount}, kRounds, {source, result});
    const Ticket ticket = expectOk(recorder.submit());
    if (expectOk(device_->waitFor(ticket, 0))) GTEST_SKIP() << "the kernel was too quick to test anything";
    lose();
    // Whoever was told may free everything: so nothing runs any more.
    std::uint32_t last = 0;
    std::memcpy(&last, result.mapped().data() + result.bytes() - 4, 4);
    std::uint32_t expected = 1;
    for (std::uint32_t k = 0; k < kRounds; ++k) expected = expected * 747796405u + 2891336453u;
    EXPECT_EQ(last, expected);
}

TEST_F(DeviceLossTest, ThingsOfALostDeviceMayBeDroppedOnAnyThread) {
    std::vector<Buffer> buffers;
    for (int i = 0; i < 100; ++i) buffers.push_back(expectOk(Buffer::create(device_, {.bytes = 64})));
    lose();
    std::thread other([kept = std::move(buffers)]() mutable { kept.clear(); });
    device_.reset();  // the last to go is a buffer, and the device with it
    other.join();
}

TEST(LossCountTest, TheThirdWithinAMinuteIsOneTooMany) {
    const LossCount::Clock::time_point start{};
    LossCount count;
    EXPECT_TRUE(count.mayGoOn(start));
    EXPECT_TRUE(count.mayGoOn(start + 30s));
    EXPECT_TRUE(count.mayGoOn(start + 60s));  // the first is forgotten
    EXPECT_FALSE(count.mayGoOn(start + 89s));
    EXPECT_FALSE(count.mayGoOn(start + 90s));
    EXPECT_TRUE(count.mayGoOn(start + 300s));
}

class LastingDeviceTest : public DeviceLossTest {
  protected:
    LastingDevice opened() {
        return expectOk(LastingDevice::open(expectOk(Instance::create()), {},
                                            [this](const Text& told) { told_.push_back(told.english()); }));
    }
    // Counts to three on the device.
    Result<void> work(const std::shared_ptr<Device>& device) {
        ++begun_;
        MACULA_TRY(const Buffer buffer, Buffer::create(device, {.bytes = 4, .memory = MemoryKind::readback}));
        for (std::uint32_t i = 1; i <= 3; ++i) {
            MACULA_TRY(Recorder recorder, Recorder::create(device, "count"));
            recorder.fill(buffer, i);
            MACULA_TRY([[maybe_unused]] const Ticket ticket, recorder.submit());
        }
        MACULA_TRY(const auto bytes, readBytes(buffer, 0, 4));
        counted_ = std::to_integer<int>(bytes[0]);
        return {};
    }
    std::vector<std::string> told_;
    int begun_ = 0;
    int counted_ = 0;
};

TEST_F(LastingDeviceTest, BeginsAnewAndFinishes) {
    LastingDevice lasting = opened();
    test::loseDeviceAt(VulkanCall::submit, 3, 2);
    expectOk(lasting.run([this](const auto& device) { return work(device); }));
    EXPECT_EQ(counted_, 3);
    EXPECT_EQ(begun_, 3);
    ASSERT_EQ(told_.size(), 2u);
    EXPECT_NE(told_[0].find("stopped responding"), std::string::npos);
    expectOk(lasting.run([this](const auto& device) { return work(device); }));  // and it stays usable
    EXPECT_EQ(begun_, 4);
}

TEST_F(LastingDeviceTest, ALossWhileTheDeviceIsMadeCountsAsOne) {
    test::loseDeviceAt(VulkanCall::create, 1);
    LastingDevice lasting = opened();
    EXPECT_EQ(told_.size(), 1u);
    // The one it has is lost, and then the next while it is made: the third within a minute.
    test::loseDeviceAt(VulkanCall::submit, 1);
    const auto losesTheNext = [this](const auto& device) {
        Result<void> done = work(device);
        if (!done.ok()) test::loseDeviceAt(VulkanCall::create, 1);
        return done;
    };
    const auto done = lasting.run(losesTheNext);
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().message, lostTooOften().message);
    EXPECT_EQ(told_.size(), 2u);
    expectOk(lasting.run([this](const auto& device) { return work(device); }));
    EXPECT_EQ(counted_, 3);
}

TEST_F(LastingDeviceTest, StopsWhenItIsLostAgainAndAgain) {
    LastingDevice lasting = opened();
    test::loseDeviceAt(VulkanCall::submit, 2, 10);
    const auto done = lasting.run([this](const auto& device) { return work(device); });
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, ErrorCode::deviceLost);
    EXPECT_EQ(done.error().message, lostTooOften().message);
    EXPECT_NE(done.error().hint.english().find("driver"), std::string::npos);
    EXPECT_EQ(begun_, kMostLosses);
    EXPECT_EQ(told_.size(), std::size_t(kMostLosses - 1));
}

TEST_F(LastingDeviceTest, WhatFailsForAnotherReasonIsNotTriedAgain) {
    LastingDevice lasting = opened();
    const auto done = lasting.run([this](const auto&) -> Result<void> {
        ++begun_;
        return Error{ErrorCode::inputNotUsable, Text("No."), {}, {}};
    });
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(begun_, 1);
    EXPECT_TRUE(told_.empty());
}

}  // namespace
}  // namespace macula::gpu
