#include "pipeline/gpu/device.h"

#include <cstdlib>
#include <thread>

#include "gpu/gpu_test.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/test_gpu.h"

namespace macula::gpu {
namespace {

class DeviceTest : public GpuTest {};

TEST_F(DeviceTest, NamesTheDeviceItTook) {
    ::testing::internal::CaptureStderr();
    const auto second = expectOk(Device::create(*instance_));
    EXPECT_EQ(::testing::internal::GetCapturedStderr(),
              fmt::format("Macula renders on {}\n", describe(second->info())));
}

TEST_F(DeviceTest, IsOverriddenByTheEnvironment) {
    setenv("MACULA_DEVICE", "no such device", 1);
    const auto refused = Device::create(*instance_);
    const auto taken = Device::create(*instance_, {.preferred = "0"});  // the option is stronger
    unsetenv("MACULA_DEVICE");
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
    EXPECT_TRUE(taken.ok() || taken.error().code == ErrorCode::deviceNotUsable);
}

TEST_F(DeviceTest, RefusesAnExtensionItDoesNotHave) {
    const auto refused = Device::create(*instance_, {.extensions = {"VK_NV_no_such_thing"}});
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::deviceNotUsable);
}

TEST_F(DeviceTest, LetsOthersChooseAndCreateIt) {
    int calls = 0;
    const auto made = Device::create(
        *instance_,
        {.physical = device()->physical(),
         .createDevice = [&](VkPhysicalDevice physical, const VkDeviceCreateInfo& info, VkDevice* result) {
             ++calls;
             return vkCreateDevice(physical, &info, nullptr, result);
         }});
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(calls, 1);
}

TEST_F(DeviceTest, OutlivesItsInstance) {
    std::shared_ptr<Device> orphan;
    {
        const Instance instance = expectOk(Instance::create());
        orphan = expectOk(Device::create(instance));
    }
    const Buffer buffer = expectOk(Buffer::create(orphan, {.label = "orphan", .bytes = 64}));
    expectOk(orphan->waitForAll());
}

TEST_F(DeviceTest, CountsTickets) {
    const Ticket before = device()->submittedTicket();
    auto recorder = expectOk(Recorder::create(device(), "empty"));
    const Ticket ticket = expectOk(recorder.submit());
    EXPECT_EQ(ticket, before + 1);
    EXPECT_EQ(device()->submittedTicket(), ticket);
    EXPECT_TRUE(expectOk(device()->waitFor(ticket)));
    EXPECT_EQ(device()->completedTicket(), ticket);
}

TEST_F(DeviceTest, DestroysABufferInFlightOnlyWhenItIsDone) {
    constexpr std::uint32_t kCount = 1u << 14;
    constexpr std::uint32_t kRounds = 60'000;  // lavapipe stops at 65535, see lavapipe_test.cpp
    const Kernel kernel = expectOk(Kernel::create(device(), shaders::slow_comp));
    const Buffer result = expectOk(Buffer::create(device(), {.label = "result", .bytes = kCount * 4}));
    std::optional<Buffer> source =
        expectOk(Buffer::create(device(), {.label = "source", .bytes = kCount * 4}));
    const std::vector<std::uint32_t> ones(kCount, 1);
    expectOk(uploadTo<std::uint32_t>(*source, ones));
    const std::vector<std::uint32_t> zeros(kCount, 0);
    expectOk(uploadTo<std::uint32_t>(result, zeros));
    expectOk(device()->waitForAll());
    ASSERT_EQ(device()->pendingDestructions(), 0u);

    auto recorder = expectOk(Recorder::create(device(), "in flight"));
    recorder.dispatch(kernel, {kCount}, kRounds, {*source, result});
    const Ticket ticket = expectOk(recorder.submit());
    source.reset();
    device()->destroyUnused();
    EXPECT_FALSE(expectOk(device()->waitFor(ticket, 0))) << "the kernel was too quick to test anything";
    EXPECT_EQ(device()->pendingDestructions(), 2u);  // the buffer and its memory

    EXPECT_TRUE(expectOk(device()->waitFor(ticket)));
    EXPECT_EQ(device()->pendingDestructions(), 0u);
    std::uint32_t expected = 1;
    for (std::uint32_t k = 0; k < kRounds; ++k) expected = expected * 747796405u + 2891336453u;
    EXPECT_EQ(expectOk(read<std::uint32_t>(result)), std::vector<std::uint32_t>(kCount, expected));
}

TEST_F(DeviceTest, KeepsWhatAnOpenRecorderMayUse) {
    const Buffer target = expectOk(Buffer::create(device(), {.label = "target", .bytes = 64}));
    std::optional<Buffer> source = expectOk(Buffer::create(device(), {.label = "source", .bytes = 64}));
    const std::vector<std::uint32_t> sevens(16, 7);
    expectOk(uploadTo<std::uint32_t>(*source, sevens));
    expectOk(device()->waitForAll());

    auto recorder = expectOk(Recorder::create(device(), "open"));
    recorder.copy(*source, 0, target, 0, 64);
    std::thread([&] { source.reset(); }).join();  // dropped on another thread, before the submission
    auto other = expectOk(Recorder::create(device(), "another"));
    expectOk(other.submit());
    expectOk(device()->waitForAll());
    EXPECT_EQ(device()->pendingDestructions(), 2u);

    expectOk(recorder.submit());
    EXPECT_EQ(expectOk(read<std::uint32_t>(target)), sevens);
    device()->destroyUnused();
    EXPECT_EQ(device()->pendingDestructions(), 0u);
}

TEST_F(DeviceTest, DestroysWhatIsLeftAtTheEnd) {
    auto second = expectOk(Device::create(*instance_));
    auto buffer = expectOk(Buffer::create(second, {.label = "left", .bytes = 64}));
    auto recorder = expectOk(Recorder::create(second, "left"));
    recorder.fill(buffer, 1);
    expectOk(recorder.submit());
    second.reset();  // the resources hold it now; no wait, no order of destruction to observe
}

}  // namespace
}  // namespace macula::gpu
