#include "pipeline/gpu/instance.h"

#include <cstdlib>

#include "base/log.h"
#include "gpu/gpu_test.h"
#include "pipeline/gpu/device_info.h"

namespace macula::gpu {
namespace {

// Runs in a process of its own: the environment is read by the Vulkan loader.
[[noreturn]] void createWithoutDriver() {
    setenv("VK_ICD_FILENAMES", "/nonexistent/driver.json", 1);
    setenv("VK_DRIVER_FILES", "/nonexistent/driver.json", 1);
    unsetenv("MACULA_VALIDATION");
    const auto instance = Instance::create({.extensions = {"VK_KHR_surface"}});
    const auto plain = Instance::create();
    if (instance.ok() || plain.ok()) std::exit(1);
    if (instance.error().code != ErrorCode::deviceNotUsable ||
        plain.error().code != ErrorCode::deviceNotUsable)
        std::exit(2);
    fmt::print(stderr, "{} / {}\n{} / {}\n", plain.error().message.english(), plain.error().hint.english(),
               instance.error().message.english(), instance.error().hint.english());
    std::exit(0);
}

TEST(InstanceDeathTest, SaysWhatToInstallWhenThereIsNoDriver) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(createWithoutDriver(), ::testing::ExitedWithCode(0),
                "no Vulkan driver.*mesa-vulkan-drivers.*\n.*no Vulkan driver.*mesa-vulkan-drivers");
}

TEST(Instance, RefusesAnExtensionThatIsNotThere) {
    const auto instance = Instance::create({.extensions = {"VK_KHR_no_such_thing"}});
    ASSERT_FALSE(instance.ok());
    EXPECT_EQ(instance.error().code, ErrorCode::deviceNotUsable);
    EXPECT_NE(instance.error().message.english().find("VK_KHR_no_such_thing"), std::string::npos)
        << instance.error().message;
}

TEST(Instance, LetsOthersCreateIt) {
    int calls = 0;
    const auto instance =
        Instance::create({.createInstance = [&](const VkInstanceCreateInfo& info, VkInstance* made) {
            ++calls;
            return vkCreateInstance(&info, nullptr, made);
        }});
    ASSERT_TRUE(instance.ok());
    EXPECT_EQ(calls, 1);
    EXPECT_NE(instance->handle(), nullptr);
}

// As often as a program that recovers from losses, or a headset that is taken off and on. A driver that is
// loaded anew each time was refused after 37.
TEST(Instance, MayBeMadeManyTimes) {
    for (int i = 0; i < 40; ++i) {
        const Instance instance = expectOk(Instance::create());
        ASSERT_TRUE(Device::create(instance, {.isAnnounced = false}).ok()) << i;
    }
}

TEST(Instance, CountsWhatTheValidationLayerSays) {
    if (validationOfTests() == Validation::off) GTEST_SKIP() << "the validation layer is not installed";
    const Instance instance = expectOk(Instance::create({.validation = Validation::on}));
    const auto device = expectOk(Device::create(instance));
    EXPECT_EQ(instance.validationMessageCount(), 0u);
    log::setLevel(log::Level::off);                                  // the two errors are wanted
    VkBufferCreateInfo wrong{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};  // size 0 and no usage
    VkBuffer buffer = VK_NULL_HANDLE;
    vkCreateBuffer(device->handle(), &wrong, nullptr, &buffer);
    if (buffer) vkDestroyBuffer(device->handle(), buffer, nullptr);
    log::setLevel(log::Level::warning);
    EXPECT_GT(instance.validationMessageCount(), 0u);
    EXPECT_EQ(instance.validationMessageCount(), instance.validationMessages().size());
}

TEST(Instance, ListsTheRealDevices) {
    const Instance instance = expectOk(Instance::create());
    const auto devices = listDevices(instance);
    ASSERT_FALSE(devices.empty());
    for (const DeviceInfo& device : devices) {
        SCOPED_TRACE(describe(device));
        EXPECT_FALSE(device.name.empty());
        if (!device.usable()) continue;
        EXPECT_FALSE(device.driver.empty());
        EXPECT_GE(device.apiVersion, VK_API_VERSION_1_3);
        EXPECT_GT(device.memoryBytes, 0u);
        EXPECT_EQ(device.threadsAtOnce == 0, device.type == DeviceType::cpu) << device.threadsAtOnce;
        EXPECT_LE(device.memoryAvailableBytes, device.memoryBytes);
        EXPECT_GE(device.maxStorageBufferBytes, 1u << 27);
        EXPECT_GE(device.maxTexelBufferElements, 65536u);
        EXPECT_GE(device.maxPushConstantBytes, 128u);
        EXPECT_GT(device.subgroupSize, 0u);
    }
    EXPECT_TRUE(chooseDevice(devices, "").ok());
}

}  // namespace
}  // namespace macula::gpu
