#include "pipeline/gpu/resources.h"

#include <numeric>

#include "gpu/gpu_test.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"

namespace macula::gpu {
namespace {

class ResourcesTest : public GpuTest {};

void expectOutOfMemory(const Error& error, std::string_view part) {
    EXPECT_EQ(error.code, ErrorCode::outOfMemory) << error.message;
    EXPECT_NE(error.message.english().find(part), std::string::npos) << error.message;
    EXPECT_FALSE(error.hint.empty());
}

TEST_F(ResourcesTest, RefusesWhatIsTooLargeWithTheNumbers) {
    const auto huge = Buffer::create(
        device(),
        {.label = "volume", .bytes = 1ull << 50, .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT});
    ASSERT_FALSE(huge.ok());
    expectOutOfMemory(huge.error(), "buffer \"volume\"");
    expectOutOfMemory(huge.error(), "1.0 PiB");

    const std::uint64_t storageLimit = device()->info().maxStorageBufferBytes;
    const auto storage = Buffer::create(device(), {.label = "storage", .bytes = storageLimit + 4});
    ASSERT_FALSE(storage.ok());
    expectOutOfMemory(storage.error(), "storage");

    const std::uint64_t texelLimit = device()->info().maxTexelBufferElements;
    for (const std::uint64_t elements : {texelLimit + 1, std::uint64_t{UINT64_MAX}}) {
        const auto texels = TexelBuffer::create(
            device(), {.label = "voxels", .elements = elements, .format = VK_FORMAT_R8_UINT});
        ASSERT_FALSE(texels.ok());
        expectOutOfMemory(texels.error(), std::to_string(elements));
        expectOutOfMemory(texels.error(), std::to_string(texelLimit));
    }

    const auto image = Image::create(device(), {.label = "wide", .width = 1u << 30, .height = 1});
    ASSERT_FALSE(image.ok());
    expectOutOfMemory(image.error(), "image \"wide\"");

    const std::uint32_t edge = device()->info().maxImageEdge3D;
    const auto volume = Image::create(
        device(),
        {.label = "solid", .shape = ImageShape::volume, .width = edge, .height = edge, .depth = edge});
    ASSERT_FALSE(volume.ok());
    expectOutOfMemory(volume.error(), "image \"solid\"");
}

TEST_F(ResourcesTest, RefusesAFormatTheDeviceCannotUse) {
    const auto writable = [&](VkFormat format) {
        VkFormatProperties properties{};
        vkGetPhysicalDeviceFormatProperties(device()->physical(), format, &properties);
        return (properties.bufferFeatures & VK_FORMAT_FEATURE_STORAGE_TEXEL_BUFFER_BIT) != 0;
    };
    VkFormat format = VK_FORMAT_UNDEFINED;
    for (int candidate = 1; candidate < VK_FORMAT_ASTC_12x12_SRGB_BLOCK; ++candidate)
        if (bytesPerTexel(VkFormat(candidate)) > 0 && !writable(VkFormat(candidate)))
            format = VkFormat(candidate);
    if (format == VK_FORMAT_UNDEFINED) GTEST_SKIP() << "the device can write texel buffers of all formats";
    const auto refused = TexelBuffer::create(
        device(), {.elements = 4, .format = format, .usage = VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT});
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::deviceNotUsable);
}

TEST_F(ResourcesTest, BytesGoThereAndBackInEveryKindOfMemory) {
    std::vector<std::uint32_t> values(100'000);
    std::iota(values.begin(), values.end(), 1u);
    for (const MemoryKind kind : {MemoryKind::deviceLocal, MemoryKind::upload, MemoryKind::readback}) {
        const Buffer buffer =
            expectOk(Buffer::create(device(), {.label = "kind", .bytes = values.size() * 4, .memory = kind}));
        expectOk(uploadTo<std::uint32_t>(buffer, values));
        EXPECT_EQ(expectOk(read<std::uint32_t>(buffer)), values);
        EXPECT_TRUE(kind == MemoryKind::deviceLocal || buffer.mapped().size() == buffer.bytes());
    }
}

// A graphics card has memory of its own; a CPU device is asked to behave like one.
TEST_F(ResourcesTest, BytesGoThereAndBackWhereTheDeviceHasMemoryOfItsOwn) {
    const auto card = expectOk(Device::create(*instance_, {.separateMemory = true}));
    EXPECT_FALSE(card->hasUnifiedMemory());
    std::vector<std::uint32_t> values((40u << 20) / 4 +
                                      3);  // more than one piece of staging, and no whole number
    std::iota(values.begin(), values.end(), 1u);
    const Buffer buffer = expectOk(Buffer::create(card, {.label = "card", .bytes = values.size() * 4}));
    EXPECT_TRUE(buffer.mapped().empty());
    expectOk(uploadTo<std::uint32_t>(buffer, values));
    EXPECT_EQ(expectOk(read<std::uint32_t>(buffer)), values);
    const TexelBuffer texels =
        expectOk(TexelBuffer::create(card, {.label = "texels", .elements = 7, .format = VK_FORMAT_R16_UINT}));
    const std::vector<std::uint16_t> odd{1, 2, 3, 4, 5, 6, 7};
    expectOk(uploadTo(texels.buffer(), 0, std::as_bytes(std::span(odd))));
    EXPECT_EQ(expectOk(read<std::uint16_t>(texels.buffer())), odd);
}

// While the device is busy an upload takes the way by staging buffers, also on a CPU device.
TEST_F(ResourcesTest, UploadsInChunksBehindWorkInFlight) {
    std::vector<std::uint32_t> values((40u << 20) / 4 + 3);
    std::iota(values.begin(), values.end(), 1u);
    const Buffer buffer =
        expectOk(Buffer::create(device(), {.label = "chunks", .bytes = values.size() * 4 + 8}));
    auto recorder = expectOk(Recorder::create(device(), "before"));
    recorder.fill(buffer, 0xffffffffu);
    for (int i = 0; i < 20; ++i) recorder.fill(buffer, 0xeeeeeeeeu);
    expectOk(recorder.submit());
    expectOk(uploadTo(buffer, 8, std::as_bytes(std::span(values))));
    const auto bytes = expectOk(readBytes(buffer, 8, values.size() * 4));
    EXPECT_EQ(std::memcmp(bytes.data(), values.data(), bytes.size()), 0);
    const auto first = expectOk(readBytes(buffer, 0, 8));
    EXPECT_EQ(first, std::vector<std::byte>(8, std::byte{0xee}));
}

TEST_F(ResourcesTest, ImagesGoThereAndBack) {
    const Image image = expectOk(
        Image::create(device(), {.label = "volume",
                                 .shape = ImageShape::volume,
                                 .width = 7,
                                 .height = 5,
                                 .depth = 3,
                                 .format = VK_FORMAT_R16_UNORM,
                                 .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                                          VK_IMAGE_USAGE_TRANSFER_DST_BIT}));
    std::vector<std::uint16_t> texels(7 * 5 * 3);
    std::iota(texels.begin(), texels.end(), std::uint16_t{1000});
    expectOk(uploadTo(image, std::as_bytes(std::span(texels))));
    EXPECT_EQ(expectOk(read<std::uint16_t>(image)), texels);
}

TEST_F(ResourcesTest, AreEmptyAfterAMove) {
    Buffer first = expectOk(Buffer::create(device(), {.label = "first", .bytes = 64}));
    Buffer second = expectOk(Buffer::create(device(), {.label = "second", .bytes = 128}));
    const VkBuffer handle = first.handle();
    second = std::move(first);
    EXPECT_EQ(second.handle(), handle);
    EXPECT_EQ(second.label(), "first");
}

}  // namespace
}  // namespace macula::gpu
