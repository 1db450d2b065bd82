#include "pipeline/gpu/recorder.h"

#include "gpu/gpu_test.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/test_gpu.h"

namespace macula::gpu {
namespace {

class RecorderTest : public GpuTest {};

TEST_F(RecorderTest, TimesItsSections) {
    constexpr std::uint32_t kCount = 4096;
    const Kernel kernel = expectOk(Kernel::create(device(), shaders::slow_comp));
    const Buffer source = expectOk(Buffer::create(device(), {.label = "source", .bytes = kCount * 4}));
    const Buffer result = expectOk(Buffer::create(device(), {.label = "result", .bytes = kCount * 4}));
    auto recorder = expectOk(Recorder::create(device(), "timed"));
    {
        // Lavapipe compiles a shader at its first dispatch.
        const auto warmUp = recorder.timed("warm-up");
        recorder.dispatch(kernel, {kCount}, std::uint32_t{1}, {source, result});
    }
    {
        const auto all = recorder.timed("all");
        recorder.fill(source, 1);
        recorder.fill(result, 0, Order::concurrent);
        {
            const auto label = recorder.label("only a label");
            const auto quick = recorder.timed("quick");
            recorder.dispatch(kernel, {kCount}, std::uint32_t{1}, {source, result});
        }
        const auto slow = recorder.timed("slow");
        recorder.dispatch(kernel, {kCount}, std::uint32_t{60'000}, {source, result});
    }
    expectOk(recorder.submit());
    const auto timings = expectOk(recorder.timings());
    if (timings.empty()) GTEST_SKIP() << "the queue has no timestamps";
    ASSERT_EQ(timings.size(), 4u);
    EXPECT_EQ(timings[1].name, "all");
    EXPECT_EQ(timings[2].name, "quick");
    EXPECT_EQ(timings[3].name, "slow");
    EXPECT_GE(timings[2].milliseconds, 0.0);
    EXPECT_GT(timings[3].milliseconds, timings[2].milliseconds);
    EXPECT_GE(timings[1].milliseconds, timings[2].milliseconds + timings[3].milliseconds - 0.01);
    EXPECT_LT(timings[1].milliseconds, 60'000.0);
}

TEST_F(RecorderTest, UpdatesABufferInOrderWithWhatReadsIt) {
    const Buffer source = expectOk(Buffer::create(device(), {.label = "source", .bytes = 8}));
    const Buffer seen = expectOk(Buffer::create(device(), {.label = "seen", .bytes = 24}));
    for (std::uint32_t i = 0; i < 3; ++i) {  // nothing waits in between
        const std::uint32_t values[] = {10 + i, 20 + i};
        auto recorder = expectOk(Recorder::create(device(), "update"));
        recorder.update(source, std::as_bytes(std::span(values)));
        recorder.copy(source, 0, seen, 8 * i, 8);
        expectOk(recorder.submit());
    }
    EXPECT_EQ(expectOk(read<std::uint32_t>(seen)), (std::vector<std::uint32_t>{10, 20, 11, 21, 12, 22}));
}

TEST_F(RecorderTest, CopiesAnImageToABuffer) {
    const Image image = expectOk(Image::create(device(), {.label = "image", .width = 9, .height = 4}));
    const Buffer buffer = expectOk(Buffer::create(
        device(),
        {.label = "pixels", .bytes = 16 + image.bytes(), .usage = 0, .memory = MemoryKind::readback}));
    VkClearColorValue colour{};
    colour.float32[0] = 0.25f;
    colour.float32[3] = 7.0f;
    auto recorder = expectOk(Recorder::create(device(), "copy"));
    recorder.clear(image, colour);
    recorder.copy(image, buffer, 16);
    expectOk(recorder.submit());
    const auto values = expectOk(read<float>(buffer));
    ASSERT_EQ(values.size(), 4u + 9 * 4 * 4);
    for (std::size_t i = 4; i < values.size(); i += 4) {
        EXPECT_EQ(values[i], 0.25f);
        EXPECT_EQ(values[i + 1], 0.0f);
        EXPECT_EQ(values[i + 3], 7.0f);
    }
}

TEST_F(RecorderTest, DiscardsWhatIsNotSubmitted) {
    const Buffer buffer = expectOk(Buffer::create(device(), {.label = "buffer", .bytes = 64}));
    const std::vector<std::uint32_t> ones(16, 1);
    expectOk(uploadTo<std::uint32_t>(buffer, ones));
    const Ticket before = device()->submittedTicket();
    {
        auto recorder = expectOk(Recorder::create(device(), "discarded"));
        recorder.fill(buffer, 2);
        const Recorder moved = std::move(recorder);
    }
    EXPECT_EQ(device()->submittedTicket(), before);
    EXPECT_EQ(expectOk(read<std::uint32_t>(buffer)), ones);
}

TEST_F(RecorderTest, RecyclesWhatItNeeds) {
    const Buffer buffer = expectOk(Buffer::create(device(), {.label = "buffer", .bytes = 64}));
    for (std::uint32_t i = 0; i < 200; ++i) {
        auto recorder = expectOk(Recorder::create(device(), "again"));
        {
            const auto timer = recorder.timed("fill");
            recorder.fill(buffer, i);
        }
        expectOk(recorder.submit());
        if (i % 7 == 0) expectOk(recorder.timings());
    }
    EXPECT_EQ(expectOk(read<std::uint32_t>(buffer)), std::vector<std::uint32_t>(16, 199));
}

using RecorderDeathTest = RecorderTest;

TEST_F(RecorderDeathTest, RefusesCopiesBeyondTheEnd) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const Buffer small = expectOk(Buffer::create(device(), {.label = "small", .bytes = 64}));
    auto recorder = expectOk(Recorder::create(device(), "beyond"));
    EXPECT_DEATH(recorder.copy(small, 60, small, 0, 8), "bytes <= buffer.bytes.. - offset");
    EXPECT_DEATH(recorder.copy(small, ~0ull, small, 0, 8), "offset <= buffer.bytes..");
    EXPECT_DEATH((void)uploadTo(small, 65, {}), "offsetBytes <= buffer.bytes..");
}

}  // namespace
}  // namespace macula::gpu
