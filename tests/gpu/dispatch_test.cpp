#include <cmath>
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

class DispatchTest : public GpuTest {
  protected:
    static constexpr std::uint32_t kCount = 1001;  // no multiple of any group size

    void SetUp() override {
        GpuTest::SetUp();
        stored_ = expectOk(TexelBuffer::create(
            device(), {.label = "stored", .elements = kCount, .format = VK_FORMAT_R16_UINT}));
        table_ = expectOk(
            TexelBuffer::create(device(), {.label = "table", .elements = 4, .format = VK_FORMAT_R32_SFLOAT}));
        result_ = expectOk(Buffer::create(device(), {.label = "result", .bytes = kCount * sizeof(float)}));
        std::vector<std::uint16_t> values(kCount);
        std::iota(values.begin(), values.end(), std::uint16_t{64000});
        expectOk(uploadTo<std::uint16_t>(stored_->buffer(), values));
        const std::vector<float> table = {0.0f, 100.0f, 200.0f, 300.0f};
        expectOk(uploadTo<float>(table_->buffer(), table));
    }

    void TearDown() override {
        stored_.reset();
        table_.reset();
        result_.reset();
        GpuTest::TearDown();
    }

    void expectAffine(float scale, float bias, float sign) {
        const auto values = expectOk(read<float>(*result_));
        for (std::uint32_t i = 0; i < kCount; ++i) {
            const auto stored = static_cast<std::uint16_t>(64000 + i);
            const float table = 100.0f * static_cast<float>(i % 4);
            ASSERT_FLOAT_EQ(values[i], sign * (static_cast<float>(stored) * scale + table + bias)) << i;
        }
    }

    std::optional<TexelBuffer> stored_;
    std::optional<TexelBuffer> table_;
    std::optional<Buffer> result_;
};

TEST_F(DispatchTest, ComputesWhatCppComputes) {
    const Kernel kernel = expectOk(Kernel::create(device(), shaders::affine_comp));
    EXPECT_EQ(kernel.name(), "affine.comp");
    EXPECT_EQ(kernel.localSize()[0], 1u);
    auto recorder = expectOk(Recorder::create(device(), "affine"));
    recorder.dispatch(kernel, {kCount}, Push{kCount, 0.25f}, {*stored_, *table_, *result_});
    expectOk(recorder.submit());
    expectAffine(0.25f, 0.5f, 1.0f);
}

TEST_F(DispatchTest, SpecializesByNameAndById) {
    const Kernel kernel =
        expectOk(Kernel::create(device(), shaders::affine_comp,
                                {.specializations = {{0, 64u}, {"kBias", -3.0f}, {"kNegate", true}}}));
    EXPECT_EQ(kernel.localSize()[0], 64u);
    auto recorder = expectOk(Recorder::create(device(), "affine"));
    recorder.dispatch(kernel, {kCount}, Push{kCount, 2.0f}, {*stored_, *table_, *result_});
    expectOk(recorder.submit());
    expectAffine(2.0f, -3.0f, -1.0f);
}

TEST_F(DispatchTest, TheDeviceKeepsWhatItCompiled) {
    const auto make = [&](float bias) {
        return expectOk(
            Kernel::create(device(), shaders::affine_comp, {.specializations = {{0, 64u}, {"kBias", bias}}}));
    };
    std::optional<Kernel> first = make(-3.0f);
    const VkPipeline pipeline = first->pipeline();
    EXPECT_NE(make(-4.0f).pipeline(), pipeline);
    EXPECT_NE(expectOk(Kernel::create(device(), shaders::affine_comp)).pipeline(), pipeline);
    first.reset();
    const Kernel again = make(-3.0f);
    EXPECT_EQ(again.pipeline(), pipeline);
    auto recorder = expectOk(Recorder::create(device(), "affine"));
    recorder.dispatch(again, {kCount}, Push{kCount, 2.0f}, {*stored_, *table_, *result_});
    expectOk(recorder.submit());
    expectAffine(2.0f, -3.0f, 1.0f);
    const auto other = expectOk(Device::create(*instance_));
    EXPECT_NE(expectOk(Kernel::create(other, shaders::affine_comp)).pipeline(), VkPipeline{});
}

// As many groups as the device reads when it comes to it: here written by the command before.
TEST_F(DispatchTest, GroupsMayBeTheDevicesToKnow) {
    const Kernel kernel =
        expectOk(Kernel::create(device(), shaders::affine_comp, {.specializations = {{0, 64u}}}));
    const Buffer groups = expectOk(Buffer::create(
        device(), {.label = "groups",
                   .bytes = 16,
                   .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT}));
    for (const std::uint32_t count : {5u, 0u, (kCount + 63u) / 64u}) {
        auto recorder = expectOk(Recorder::create(device(), "affine"));
        const std::uint32_t words[] = {99, count, 1, 1};
        recorder.fill(*result_, 0);
        recorder.update(groups, std::as_bytes(std::span(words)));
        recorder.dispatch(kernel, Recorder::Groups{groups, 4}, Push{kCount, 0.25f},
                          {*stored_, *table_, *result_});
        expectOk(recorder.submit());
        const auto values = expectOk(read<float>(*result_));
        for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(values[i] != 0.0f, i < 64u * count) << i;
    }
    expectAffine(0.25f, 0.5f, 1.0f);
}

// The first dispatch writes what the second reads, without a barrier by the caller.
TEST_F(DispatchTest, DispatchesWaitForTheOnesBefore) {
    const Kernel kernel = expectOk(Kernel::create(device(), shaders::slow_comp));
    std::vector<Buffer> chain;
    for (int i = 0; i < 9; ++i)
        chain.push_back(expectOk(Buffer::create(device(), {.label = "chain", .bytes = 4096})));
    auto recorder = expectOk(Recorder::create(device(), "chain"));
    for (const Buffer& buffer : chain) recorder.fill(buffer, 1, Order::concurrent);
    recorder.barrier();
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        recorder.dispatch(kernel, {1024}, std::uint32_t{0}, {chain[i], chain[i + 1]});
    expectOk(recorder.submit());
    EXPECT_EQ(expectOk(read<std::uint32_t>(chain.back())), std::vector<std::uint32_t>(1024, 9));
}

TEST_F(DispatchTest, SamplesAVolumeAndWritesAPicture) {
    const Kernel kernel = expectOk(Kernel::create(device(), shaders::picture_comp));
    const Image volume = expectOk(
        Image::create(device(), {.label = "volume",
                                 .shape = ImageShape::volume,
                                 .width = 2,
                                 .height = 1,
                                 .depth = 1,
                                 .format = VK_FORMAT_R8_UNORM,
                                 .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}));
    const Sampler sampler = expectOk(Sampler::create(device()));
    const Image picture = expectOk(Image::create(
        device(), {.label = "picture", .width = 101, .height = 50, .format = VK_FORMAT_R8G8B8A8_UNORM}));
    const std::uint8_t voxels[] = {0, 255};
    expectOk(uploadTo(volume, std::as_bytes(std::span(voxels))));

    auto recorder = expectOk(Recorder::create(device(), "picture"));
    recorder.dispatch(kernel, {101, 50}, {{volume, sampler}, picture});
    expectOk(recorder.submit());
    const auto pixels = expectOk(read<std::uint8_t>(picture));
    const auto near = [](int value, double expected) { return std::abs(value - expected) <= 1.5; };
    for (int y = 0; y < 50; ++y) {
        for (int x = 0; x < 101; ++x) {
            const std::uint8_t* pixel =
                &pixels[4 * (101 * static_cast<std::size_t>(y) + static_cast<std::size_t>(x))];
            const double u = (x + 0.5) / 101.0;
            const double v = (y + 0.5) / 50.0;
            const double linear = std::clamp(2.0 * u - 0.5, 0.0, 1.0);
            ASSERT_TRUE(near(pixel[0], 255.0 * u)) << x << ", " << y;
            ASSERT_TRUE(near(pixel[1], 255.0 * v)) << x << ", " << y;
            ASSERT_TRUE(near(pixel[2], 255.0 * linear)) << x << ", " << y << ": " << int(pixel[2]);
            ASSERT_EQ(pixel[3], 255);
        }
    }
}

using DispatchDeathTest = DispatchTest;

TEST_F(DispatchDeathTest, RefusesWhatDoesNotFitTheShader) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");  // lavapipe has threads of its own
    const Kernel kernel = expectOk(Kernel::create(device(), shaders::affine_comp));
    const Push push{kCount, 1.0f};
    auto recorder = expectOk(Recorder::create(device(), "wrong"));
    EXPECT_DEATH(recorder.dispatch(kernel, {1}, std::uint64_t{0} + 1.0f, {*stored_, *table_, *result_}),
                 "affine.comp: the shader has 8 bytes of push constants, the call 4");
    EXPECT_DEATH(recorder.dispatch(kernel, {1}, {*stored_, *table_, *result_}), "the call 0");
    EXPECT_DEATH(recorder.dispatch(kernel, Recorder::Groups{*result_}, push, {*stored_, *table_, *result_}),
                 "INDIRECT");
    EXPECT_DEATH(recorder.dispatch(kernel, {1}, push, {*stored_, *table_}),
                 "the shader has 3 bindings, the call 2");
    EXPECT_DEATH(recorder.dispatch(kernel, {1}, push, {*stored_, *result_, *result_}),
                 "\"result\" cannot be bound to table .binding 2.");
    EXPECT_DEATH(recorder.dispatch(kernel, {0xffffffffu}, push, {*stored_, *table_, *result_}),
                 "groups along axis 0");
}

TEST_F(DispatchDeathTest, RefusesASpecializationTheShaderDoesNotHave) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const KernelOptions options{.specializations = {{"kBais", 1.0f}}};
    EXPECT_DEATH((void)Kernel::create(device(), shaders::affine_comp, options),
                 "no specialization constant \"kBais\"");
}

}  // namespace
}  // namespace macula::gpu
