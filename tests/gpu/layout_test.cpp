#include "gpu/gpu_test.h"
#include "gpu/shared_layout.h"
#include "gpu/test_struct.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "shaders/test_gpu.h"

namespace macula::gpu {
namespace {

using shared::TestLight;
using shared::TestScene;

const std::vector<LaidOutField> kLightFields = {
    MACULA_FIELD(TestLight, direction), MACULA_FIELD(TestLight, intensity), MACULA_FIELD(TestLight, colour),
    MACULA_FIELD(TestLight, flags), MACULA_FIELD(TestLight, size)};

TEST(SharedLayout, IsTheSameInCppAndGlsl) {
    const auto reflection = reflectSpirv(shaders::layout_comp.words);
    ASSERT_TRUE(reflection.ok());
    ASSERT_EQ(reflection->bindings.size(), 3u);
    for (const int buffer : {0, 1}) {
        const ReflectedMember* scene =
            reflection->bindings[static_cast<std::size_t>(buffer)].block.find("scene");
        ASSERT_NE(scene, nullptr);
        expectLayoutMatches<TestScene>(
            *scene, {MACULA_FIELD(TestScene, worldFromView), MACULA_FIELD(TestScene, origin),
                     MACULA_FIELD(TestScene, frame), MACULA_FIELD(TestScene, exposure),
                     MACULA_FIELD(TestScene, tint), MACULA_FIELD(TestScene, rotation),
                     MACULA_FIELD(TestScene, counts), MACULA_FIELD(TestScene, offset),
                     MACULA_FIELD(TestScene, lights), MACULA_FIELD(TestScene, tail)});
        ASSERT_NE(scene->find("lights"), nullptr);
        expectLayoutMatches<TestLight>(*scene->find("lights"), kLightFields);
    }
    ASSERT_TRUE(reflection->pushConstants.has_value());
    ASSERT_NE(reflection->pushConstants->block.find("light"), nullptr);
    expectLayoutMatches<TestLight>(*reflection->pushConstants->block.find("light"), kLightFields);
}

// std140 spreads arrays of floats over 16 bytes each: the reason for the scalar layout, and a check on the
// reflection.
TEST(SharedLayout, SeesWhatOtherLayoutsDo) {
    const auto reflection = reflectSpirv(shaders::layout_comp.words);
    ASSERT_TRUE(reflection.ok());
    const ReflectedMember& block = reflection->bindings[2].block;
    EXPECT_EQ(reflection->bindings[2].type, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
    ASSERT_EQ(block.members.size(), 4u);
    EXPECT_EQ(block.find("b")->offset, 12u);
    EXPECT_EQ(block.find("list")->offset, 16u);
    EXPECT_EQ(block.find("list")->arrayStride, 16u);
    EXPECT_EQ(block.find("c")->offset, 48u);
}

class LayoutTest : public GpuTest {};

TEST_F(LayoutTest, ValuesArriveWhereTheyBelong) {
    const Kernel kernel = expectOk(Kernel::create(device(), shaders::layout_comp));
    const Buffer source = expectOk(Buffer::create(device(), {.label = "source", .bytes = sizeof(TestScene)}));
    const Buffer target = expectOk(Buffer::create(device(), {.label = "target", .bytes = sizeof(TestScene)}));
    const Buffer misfit = expectOk(Buffer::create(
        device(), {.label = "misfit", .bytes = 64, .usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT}));
    std::vector<float> numbers(sizeof(TestScene) / 4);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(i + 1);
    std::vector<float> misfitNumbers(16, 0.0f);
    misfitNumbers[3] = 1000.0f;  // b
    expectOk(uploadTo<float>(source, numbers));
    expectOk(uploadTo<float>(misfit, misfitNumbers));
    TestLight light{};
    light.direction = {-1.0f, -2.0f, -3.0f};
    light.size = {-9.0f, -10.0f};

    auto recorder = expectOk(Recorder::create(device(), "layout"));
    recorder.fill(target, 0);
    recorder.dispatch(kernel, {1}, light, {source, target, misfit});
    expectOk(recorder.submit());
    TestScene expected{};
    std::memcpy(&expected, numbers.data(), sizeof(expected));
    expected.exposure += 1000.0f;
    expected.lights[1] = light;
    const auto bytes = expectOk(readBytes(target, 0, sizeof(TestScene)));
    EXPECT_EQ(std::memcmp(bytes.data(), &expected, sizeof(expected)), 0);
}

}  // namespace
}  // namespace macula::gpu
