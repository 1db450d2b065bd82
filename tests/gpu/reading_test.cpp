// Bytes that come from the device while it goes on.
#include "pipeline/gpu/reading.h"

#include <vector>

#include "gpu/gpu_test.h"
#include "gpu/lose_device.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"

namespace macula::gpu {
namespace {

// With memory of its own, and with the host's.
class ReadingTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        devices_ = {expectOk(Device::create(*instance_, {.separateMemory = true, .isAnnounced = false})),
                    device()};
    }
    void TearDown() override {
        test::loseDeviceAt(test::VulkanCall::submit, 1, 0);
        devices_.clear();
        GpuTest::TearDown();
    }
    static Buffer filled(const std::shared_ptr<Device>& device, std::uint64_t bytes, std::uint32_t value) {
        Buffer made = expectOk(Buffer::create(device, {.label = "numbers", .bytes = bytes}));
        fill(made, value);
        return made;
    }
    static void fill(const Buffer& buffer, std::uint32_t value) {
        auto recorder = expectOk(Recorder::create(buffer.device(), "fill"));
        recorder.fill(buffer, value);
        static_cast<void>(expectOk(recorder.submit()));
    }
    static void expectAll(std::span<const std::uint32_t> values, std::size_t count, std::uint32_t value) {
        ASSERT_EQ(values.size(), count);
        for (const std::uint32_t v : values) ASSERT_EQ(v, value);
    }

    std::vector<std::shared_ptr<Device>> devices_;
};

TEST_F(ReadingTest, IsOfWhatWasThereWhenItWasBegun) {
    for (const auto& device : devices_) {
        const Buffer small = filled(device, 4, 1);
        const Buffer odd = filled(device, 52, 2);
        const Buffer large = filled(device, 4'000'000, 3);
        Reading reading;
        const std::uint64_t before = device->bytesRead();
        expectOk(reading.begin({&small, &odd, &large}));
        for (const Buffer* buffer : {&small, &odd, &large}) fill(*buffer, 99);
        expectOk(reading.finish());
        expectOk(reading.finish());
        expectAll(reading.part<std::uint32_t>(0), 1, 1);
        expectAll(reading.part<std::uint32_t>(1), 13, 2);
        expectAll(reading.part<std::uint32_t>(2), 1'000'000, 3);
        EXPECT_EQ(device->bytesRead() - before, 4'000'056u);
    }
}

TEST_F(ReadingTest, TakesTheSameMemoryAgain) {
    for (const auto& device : devices_) {
        const Buffer large = filled(device, 400'000, 3);
        const Buffer small = filled(device, 400, 4);
        Reading reading;
        expectOk(reading.begin({&large}));
        const std::uint64_t made = device->staging().made();
        for (std::uint32_t i = 0; i < 10; ++i) {
            fill(i % 2 == 0 ? small : large, i);
            expectOk(reading.begin({i % 2 == 0 ? &small : &large}));  // what was under way is given up
            if (i % 3 == 0) continue;
            expectOk(reading.finish());
            expectAll(reading.part<std::uint32_t>(0), i % 2 == 0 ? 100 : 100'000, i);
        }
        EXPECT_EQ(device->staging().made(), made);
    }
}

TEST_F(ReadingTest, CanBeDroppedOnTheWay) {
    for (const auto& device : devices_) {
        const Buffer buffer = filled(device, 4000, 7);
        {
            Reading reading;
            expectOk(reading.begin({&buffer}));
        }
        EXPECT_EQ(expectOk(read<std::uint32_t>(buffer)), std::vector<std::uint32_t>(1000, 7));
        const Reading never;
    }
}

// Without memory for the copies they are read in portions, which waits; with it again they are on their way.
TEST_F(ReadingTest, ComesInPortionsWhereMemoryIsShort) {
    const Buffer large = filled(devices_[0], 400'000, 3);
    const Buffer small = filled(devices_[0], 400, 4);
    Reading reading;
    {
        const test::NoMemory full(100'000);
        expectOk(reading.begin({&large, &small}));
        EXPECT_GT(full.refused(), 0);
        fill(large, 99);
        expectOk(reading.finish());
    }
    expectAll(reading.part<std::uint32_t>(0), 100'000, 3);
    expectAll(reading.part<std::uint32_t>(1), 100, 4);
    expectOk(reading.begin({&large, &small}));
    expectOk(reading.finish());
    expectAll(reading.part<std::uint32_t>(0), 100'000, 99);
    devices_[0]->staging().clear(devices_[0]);
    expectOk(devices_[0]->waitForAll());
    Reading other;
    {
        const test::NoMemory full;
        const Result<void> none = other.begin({&large});
        ASSERT_FALSE(none.ok());
        EXPECT_EQ(none.error().code, ErrorCode::outOfMemory);
    }
    expectOk(other.begin({&large}));
    expectOk(other.finish());
    expectAll(other.part<std::uint32_t>(0), 100'000, 99);
}

TEST_F(ReadingTest, OnALostDeviceIsAnError) {
    const Buffer buffer = filled(devices_[0], 4000, 7);
    Reading reading;
    expectOk(reading.begin({&buffer}));
    expectOk(reading.finish());
    test::loseDeviceAt(test::VulkanCall::submit, 1);
    EXPECT_EQ(reading.begin({&buffer}).error().code, ErrorCode::deviceLost);
    EXPECT_EQ(reading.begin({&buffer}).error().code, ErrorCode::deviceLost);
}

// What never came is not taken for what came.
TEST_F(ReadingTest, OfADeviceThatIsLostOnTheWayIsAnError) {
    const Buffer buffer = filled(devices_[0], 4000, 7);
    Reading reading;
    expectOk(reading.begin({&buffer}));
    test::loseDeviceAt(test::VulkanCall::wait, 1);
    EXPECT_EQ(reading.finish().error().code, ErrorCode::deviceLost);
    EXPECT_EQ(test::devicesLost(), 1);
    EXPECT_EQ(reading.finish().error().code, ErrorCode::deviceLost) << "and stays one";
    EXPECT_EQ(reading.begin({&buffer}).error().code, ErrorCode::deviceLost);
}

}  // namespace
}  // namespace macula::gpu
