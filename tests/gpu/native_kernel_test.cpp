#include "pipeline/gpu/native_kernel.h"

#include <new>
#include <numeric>

#include "gpu/gpu_test.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/test_gpu.h"

namespace macula::gpu {
namespace {

struct Push {
    std::uint32_t count;
    float scale;
};

// A twin of affine.comp that adds a hundred thousand, so that its results differ from those of the shader.
constexpr float kMark = 100'000.0f;
void affine(const NativeDispatch& dispatch) {
    const auto stored = dispatch.binding<const std::uint16_t>(0);
    const auto table = dispatch.binding<const float>(2);
    const auto result = dispatch.binding<float>(5);
    const auto push = dispatch.push<Push>();
    ASSERT_GE(dispatch.groups()[0], push.count);
    for (std::uint32_t i = 0; i < push.count; ++i)
        result[i] = float(stored[i]) * push.scale + table[i % 4] + kMark;
}

class NativeKernelTest : public GpuTest {
  protected:
    static constexpr std::uint32_t kCount = 8;

    void SetUp() override {
        GpuTest::SetUp();
        if (!device()->isCpu()) GTEST_SKIP() << "the device is not the CPU";
    }

    Kernel affineKernel(NativeKernel native = affine) {
        return expectOk(Kernel::create(device(), shaders::affine_comp, {.native = std::move(native)}));
    }
    TexelBuffer values(const std::vector<std::uint16_t>& content, std::uint64_t elementsOfView = 0) {
        TexelBuffer made = expectOk(TexelBuffer::create(device(), {.label = "stored",
                                                                   .elements = content.size(),
                                                                   .format = VK_FORMAT_R16_UINT,
                                                                   .elementsOfView = elementsOfView}));
        expectOk(uploadTo<std::uint16_t>(made.buffer(), content));
        return made;
    }
    TexelBuffer table() {
        TexelBuffer made = expectOk(
            TexelBuffer::create(device(), {.label = "table", .elements = 4, .format = VK_FORMAT_R32_SFLOAT}));
        expectOk(uploadTo<float>(made.buffer(), std::vector<float>{0.0f, 10.0f, 20.0f, 30.0f}));
        return made;
    }
    Buffer result() {
        return expectOk(Buffer::create(device(), {.label = "result", .bytes = kCount * sizeof(float)}));
    }
};

std::vector<std::uint16_t> counted(std::size_t count) {
    std::vector<std::uint16_t> values(count);
    std::iota(values.begin(), values.end(), std::uint16_t{1});
    return values;
}

TEST_F(NativeKernelTest, RunsInItsPlaceAmongTheCommands) {
    const Kernel kernel = affineKernel();
    const TexelBuffer stored = values(counted(kCount));
    const TexelBuffer table = this->table();
    const Buffer result = this->result();
    const Buffer seen = expectOk(Buffer::create(device(), {.label = "seen", .bytes = 3 * kCount * 4}));
    auto recorder = expectOk(Recorder::create(device(), "in order"));
    recorder.fill(result, 0);
    recorder.copy(result, 0, seen, 0, kCount * 4);
    recorder.dispatch(kernel, {kCount}, Push{kCount, 2.0f}, {stored, table, result});
    recorder.copy(result, 0, seen, kCount * 4, kCount * 4);
    recorder.dispatch(kernel, {kCount}, Push{1, 5.0f}, {stored, table, result});
    recorder.dispatch(kernel, {kCount}, Push{2, 3.0f}, {stored, table, result});
    recorder.copy(result, 0, seen, 2 * kCount * 4, kCount * 4);
    expectOk(recorder.submit());
    const auto found = expectOk(read<float>(seen));
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const float table4 = 10.0f * float(i % 4);
        EXPECT_EQ(found[i], 0.0f);
        EXPECT_EQ(found[kCount + i], 2.0f * float(i + 1) + table4 + kMark);
        EXPECT_EQ(found[2 * kCount + i], (i < 2 ? 3.0f : 2.0f) * float(i + 1) + table4 + kMark);
    }
}

TEST_F(NativeKernelTest, SeesWhatEarlierSubmissionsWrote) {
    const Kernel kernel = affineKernel();
    const TexelBuffer stored = values(counted(kCount));
    const TexelBuffer table = this->table();
    const Buffer result = this->result();
    for (std::uint32_t i = 0; i < 3; ++i) {
        auto fill = expectOk(Recorder::create(device(), "fill"));
        fill.fill(stored.buffer(), i | i << 16);
        expectOk(fill.submit());
        auto recorder = expectOk(Recorder::create(device(), "alone"));
        recorder.dispatch(kernel, {kCount}, Push{kCount, 1.0f}, {stored, table, result});
        expectOk(recorder.submit());
        EXPECT_EQ(expectOk(read<float>(result))[0], float(i) + kMark);
    }
}

TEST_F(NativeKernelTest, ReadsATexelBufferFromItsViewOn) {
    const Kernel kernel = affineKernel();
    const TexelBuffer stored = values(counted(128 + kCount), 128);
    const TexelBuffer table = this->table();
    const Buffer result = this->result();
    auto recorder = expectOk(Recorder::create(device(), "view"));
    recorder.dispatch(kernel, {kCount}, Push{kCount, 1.0f}, {Binding(stored, 1), table, result});
    expectOk(recorder.submit());
    EXPECT_EQ(expectOk(read<float>(result))[0], 129.0f + kMark);
}

TEST_F(NativeKernelTest, ReadsTheGroupsOfAnIndirectDispatchWhenItRuns) {
    std::array<std::uint32_t, 3> seen{};
    const Kernel kernel = affineKernel([&](const NativeDispatch& dispatch) { seen = dispatch.groups(); });
    const TexelBuffer stored = values(counted(kCount));
    const TexelBuffer table = this->table();
    const Buffer result = this->result();
    const Buffer groups = expectOk(Buffer::create(
        device(), {.label = "groups", .bytes = 16, .usage = VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT}));
    auto recorder = expectOk(Recorder::create(device(), "indirect"));
    const std::uint32_t written[] = {0, 7, 2, 1};
    recorder.update(groups, std::as_bytes(std::span(written)));
    recorder.dispatch(kernel, Recorder::Groups{groups, 4}, Push{1, 1.0f}, {stored, table, result});
    expectOk(recorder.submit());
    EXPECT_EQ(seen, (std::array<std::uint32_t, 3>{7, 2, 1}));
}

TEST_F(NativeKernelTest, IsTimed) {
    const Kernel kernel = affineKernel();
    const TexelBuffer stored = values(counted(kCount));
    const TexelBuffer table = this->table();
    const Buffer result = this->result();
    auto recorder = expectOk(Recorder::create(device(), "timed"));
    {
        const auto all = recorder.timed("all");
        recorder.fill(result, 0);
        const auto native = recorder.timed("native");
        recorder.dispatch(kernel, {kCount}, Push{kCount, 1.0f}, {stored, table, result});
    }
    expectOk(recorder.submit());
    const auto timings = expectOk(recorder.timings());
    ASSERT_EQ(timings.size(), 2u);
    EXPECT_GE(timings[1].milliseconds, 0.0);
    EXPECT_GE(timings[0].milliseconds, timings[1].milliseconds);
}

TEST_F(NativeKernelTest, TellsThatMemoryIsShort) {
    const Kernel kernel = affineKernel([](const NativeDispatch&) { throw std::bad_alloc(); });
    const TexelBuffer stored = values(counted(kCount));
    const TexelBuffer table = this->table();
    const Buffer result = this->result();
    auto recorder = expectOk(Recorder::create(device(), "short"));
    recorder.dispatch(kernel, {kCount}, Push{kCount, 1.0f}, {stored, table, result});
    const auto submitted = recorder.submit();
    ASSERT_FALSE(submitted.ok());
    EXPECT_EQ(submitted.error().code, ErrorCode::outOfMemory);
    EXPECT_FALSE(device()->lost());
}

// A recording has several command buffers then, but is one: what is dropped later is destroyed.
TEST_F(NativeKernelTest, LeavesNothingThatCannotBeDestroyed) {
    const Kernel kernel = affineKernel();
    const TexelBuffer stored = values(counted(kCount));
    const TexelBuffer table = this->table();
    std::optional<Buffer> result = this->result();
    const auto recorded = [&] {
        auto recorder = expectOk(Recorder::create(device(), "dropped"));
        recorder.fill(*result, 0);
        recorder.dispatch(kernel, {kCount}, Push{kCount, 1.0f}, {stored, table, *result});
        recorder.dispatch(kernel, {kCount}, Push{kCount, 2.0f}, {stored, table, *result});
        return recorder;
    };
    { auto recorder = recorded(); }  // not submitted
    {
        auto recorder = recorded();
        expectOk(recorder.submit());
    }
    expectOk(device()->waitForAll());
    result.reset();
    expectOk(device()->waitForAll());
    EXPECT_EQ(device()->pendingDestructions(), 0u);
}

TEST_F(NativeKernelTest, DoesNotRunWhereItIsForbidden) {
    device_.reset();
    device_ = expectOk(Device::create(*instance_, {.nativeKernels = false}));
    EXPECT_FALSE(device()->runsNatively());
    const Kernel kernel = affineKernel();
    const TexelBuffer stored = values(counted(kCount));
    const TexelBuffer table = this->table();
    const Buffer result = this->result();
    auto recorder = expectOk(Recorder::create(device(), "shader"));
    recorder.dispatch(kernel, {kCount}, Push{kCount, 1.0f}, {stored, table, result});
    expectOk(recorder.submit());
    EXPECT_EQ(expectOk(read<float>(result))[0], 1.5f);
}

}  // namespace
}  // namespace macula::gpu
