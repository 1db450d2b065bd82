#include <gtest/gtest.h>

#include "pipeline/gpu/device_info.h"
#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {
namespace {

DeviceInfo fake(std::size_t index, const char* name, DeviceType type, Text whyNotUsable = {}) {
    DeviceInfo info;
    info.index = index;
    info.name = name;
    info.type = type;
    info.whyNotUsable = std::move(whyNotUsable);
    return info;
}

const std::vector<DeviceInfo> kDevices = {
    fake(0, "llvmpipe (LLVM 15.0.6, 256 bits)", DeviceType::cpu),
    fake(1, "Intel UHD 770", DeviceType::integrated),
    fake(2, "NVIDIA Old", DeviceType::discrete, Text("it offers Vulkan {}.{}, and 1.3 is needed", 1, 2)),
    fake(3, "NVIDIA H100", DeviceType::discrete),
    fake(4, "NVIDIA H200", DeviceType::discrete),
};

std::string chosenName(std::span<const DeviceInfo> devices, std::string_view preferred) {
    const auto result = chooseDevice(devices, preferred);
    return result.ok() ? result->name : "error: " + result.error().message.english();
}

TEST(Chooser, PrefersDiscreteThenIntegratedThenVirtualThenCpu) {
    EXPECT_EQ(chosenName(kDevices, ""), "NVIDIA H100");
    EXPECT_EQ(chosenName(std::span(kDevices).first(3), ""), "Intel UHD 770");
    EXPECT_EQ(chosenName(std::span(kDevices).first(1), ""), kDevices[0].name);
    const std::vector<DeviceInfo> virtualAndCpu = {kDevices[0], fake(1, "virtio", DeviceType::virtualGpu)};
    EXPECT_EQ(chosenName(virtualAndCpu, ""), "virtio");
}

TEST(Chooser, IsOverriddenByIndexOrPartOfTheName) {
    EXPECT_EQ(chosenName(kDevices, "0"), kDevices[0].name);
    EXPECT_EQ(chosenName(kDevices, "LLVMpipe"), kDevices[0].name);
    EXPECT_EQ(chosenName(kDevices, "h200"), "NVIDIA H200");
    EXPECT_EQ(chosenName(kDevices, "nvidia"), "NVIDIA H100") << "the first usable one of that name";
}

TEST(Chooser, SaysWhatThereIsWhenTheNameIsUnknown) {
    for (const char* unknown : {"radeon", "7", "-1", "99999999999999999999999"}) {
        const auto result = chooseDevice(kDevices, unknown);
        ASSERT_FALSE(result.ok());
        EXPECT_EQ(result.error().code, ErrorCode::usage);
        for (const DeviceInfo& device : kDevices)
            EXPECT_NE(result.error().hint.english().find(device.name), std::string::npos)
                << result.error().hint;
    }
}

TEST(Chooser, SaysWhyADeviceCannotBeUsed) {
    const auto preferred = chooseDevice(kDevices, "2");
    ASSERT_FALSE(preferred.ok());
    EXPECT_EQ(preferred.error().code, ErrorCode::deviceNotUsable);
    EXPECT_EQ(preferred.error().message,
              "The device NVIDIA Old cannot be used: it offers Vulkan 1.2, and 1.3 is needed.");
    EXPECT_FALSE(chooseDevice(std::span(kDevices).subspan(2, 1), "").ok());
}

TEST(Chooser, NamesThePackageWhenThereIsNoDevice) {
    const auto result = chooseDevice({}, "");
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::deviceNotUsable);
    EXPECT_NE(result.error().hint.english().find("mesa-vulkan-drivers"), std::string::npos);
}

TEST(VulkanError, TurnsResultsIntoSentences) {
    EXPECT_EQ(vulkanError(VK_ERROR_OUT_OF_DEVICE_MEMORY, Text("get 2.0 GiB")).code, ErrorCode::outOfMemory);
    EXPECT_EQ(vulkanError(VK_ERROR_OUT_OF_HOST_MEMORY, Text("get 2.0 GiB")).code, ErrorCode::outOfMemory);
    const Error lost = vulkanError(VK_ERROR_DEVICE_LOST, Text("wait for the graphics device"));
    EXPECT_EQ(lost.code, ErrorCode::deviceLost);
    EXPECT_EQ(
        lost.message,
        "Could not wait for the graphics device: the graphics device stopped responding and was reset.");
    EXPECT_FALSE(lost.hint.empty());
}

TEST(VulkanError, WritesBytesForPeople) {
    EXPECT_EQ(bytesText(1023), "1023 bytes");
    EXPECT_EQ(bytesText(1536), "1.5 KiB");
    EXPECT_EQ(bytesText(2ull << 30), "2.0 GiB");
    EXPECT_EQ(bytesText(~0ull), "16.0 EiB");
}

TEST(SubgroupSize, IsNarrowWhereThreadsPartWays) {
    const auto sizeFor = [](std::uint32_t least, std::uint32_t most) {
        return subgroupSizeForDivergence({.minSubgroupSize = least, .maxSubgroupSize = most});
    };
    EXPECT_EQ(sizeFor(32, 64), 32u);  // AMD since RDNA
    EXPECT_EQ(sizeFor(64, 64), 0u);   // AMD before
    EXPECT_EQ(sizeFor(32, 32), 0u);   // NVIDIA
    EXPECT_EQ(sizeFor(8, 32), 0u);    // Intel
    EXPECT_EQ(sizeFor(8, 8), 0u);     // lavapipe
    EXPECT_EQ(sizeFor(0, 0), 0u);     // none can be required
}

}  // namespace
}  // namespace macula::gpu
