#include "pipeline/gpu/device.h"

#include <algorithm>
#include <cstdlib>

#include "base/check.h"
#include "base/give_way.h"
#include "base/log.h"
#include "base/timeline.h"
#include "pipeline/gpu/instance_state.h"
#include "pipeline/gpu/physical_device.h"
#include "pipeline/gpu/pipeline_cache.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/staging_pool.h"
#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {
namespace {

// Which of our optional features the device has; all required ones were checked by listDevices.
struct Features {
    VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
    VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &v13};
    VkPhysicalDeviceVulkan11Features v11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES, &v12};
    VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &v11, {}};

    explicit Features(VkPhysicalDevice device) {
        const Offered offered(device);
        core.features.shaderStorageImageReadWithoutFormat =
            offered.core.features.shaderStorageImageReadWithoutFormat;
        core.features.shaderStorageImageWriteWithoutFormat =
            offered.core.features.shaderStorageImageWriteWithoutFormat;
        v12.timelineSemaphore = VK_TRUE;
        v12.scalarBlockLayout = VK_TRUE;
        v13.synchronization2 = VK_TRUE;
        v13.maintenance4 = VK_TRUE;
        v13.subgroupSizeControl = offered.v13.subgroupSizeControl;
        v13.computeFullSubgroups = offered.v13.computeFullSubgroups;
    }
    Features(const Features&) = delete;
    Features& operator=(const Features&) = delete;

  private:
    struct Offered {
        VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
        VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &v13};
        VkPhysicalDeviceVulkan11Features v11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES, &v12};
        VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &v11, {}};

        explicit Offered(VkPhysicalDevice device) { vkGetPhysicalDeviceFeatures2(device, &core); }
        Offered(const Offered&) = delete;
        Offered& operator=(const Offered&) = delete;
    };
};

Result<DeviceInfo> chosen(const Instance& instance, const DeviceOptions& options) {
    const auto devices = listDevices(instance);
    if (options.physical != VK_NULL_HANDLE) {
        for (const DeviceInfo& device : devices)
            if (device.physical == options.physical) return chooseDevice(std::span(&device, 1), "");
        if (options.lent)
            return Error{ErrorCode::deviceNotUsable,
                         "The graphics device that was lent is not one of its VkInstance.", "",
                         "Give the VkInstance and the VkPhysicalDevice that the device was made of."};
        return Error{ErrorCode::deviceNotUsable, "The headset asks for a graphics device that is not there.",
                     "", "Restart the headset's software."};
    }
    const char* environment = std::getenv("MACULA_DEVICE");
    const std::string preferred =
        !options.preferred.empty() ? options.preferred : std::string(environment ? environment : "");
    return chooseDevice(devices, preferred);
}

}  // namespace

Device::Device() : staging_(std::make_unique<StagingPool>()) {}

Result<std::shared_ptr<Device>> Device::create(const Instance& instance, const DeviceOptions& options) {
    std::shared_ptr<Device> device(new Device());
    MACULA_TRY_VOID(device->initialise(instance, options));
    if (options.isAnnounced) log::announce(fmt::format("Macula renders on {}", describe(device->info())));
    return device;
}

Result<void> Device::initialise(const Instance& instance, const DeviceOptions& options) {
    instanceState_ = instance.state_;
    instance_ = instance.handle();
    MACULA_TRY(info_, chosen(instance, options));
    unifiedMemory_ = (isCpu() || info_.type == DeviceType::integrated) && !options.separateMemory;
    const std::string doing = fmt::format("open the device {}", info_.name);
    if (options.lent) {
        MACULA_TRY_VOID(borrow(*options.lent, options.physical));
    } else {
        MACULA_TRY_VOID(open(options, doing));
    }

    const auto load = [&](auto& function, const char* name) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(vkGetDeviceProcAddr(device_, name));
    };
    load(functions_.cmdPushDescriptorSet, "vkCmdPushDescriptorSetKHR");
    if (!functions_.cmdPushDescriptorSet)
        return Error{ErrorCode::deviceNotUsable,
                     fmt::format("The device {} was opened without what Macula needs of it.", info_.name), "",
                     "Open it with VK_KHR_push_descriptor."};
    if (instance.hasDebugUtils()) {
        load(functions_.setObjectName, "vkSetDebugUtilsObjectNameEXT");
        load(functions_.cmdBeginLabel, "vkCmdBeginDebugUtilsLabelEXT");
        load(functions_.cmdEndLabel, "vkCmdEndDebugUtilsLabelEXT");
    }

    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(info_.physical, &properties);
    timestampPeriodNs_ = properties.limits.timestampPeriod;
    timestampBits_ = timestampBits(info_.physical, queueFamily_);
    std::copy_n(properties.limits.maxComputeWorkGroupCount, 3, maxGroups_);

    VkSemaphoreTypeCreateInfo timeline{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
    timeline.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
    const VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, &timeline, 0};
    MACULA_VK_TRY(vkCreateSemaphore(device_, &semaphore, nullptr, &timeline_), doing);
    setName(VK_OBJECT_TYPE_SEMAPHORE, reinterpret_cast<std::uint64_t>(timeline_), "timeline");
    // The files of a host's device are the host's business.
    if (!options.kernelsFolder.empty() && !isLent_)
        pipelineCache_ = PipelineCache::open(device_, info_.physical, options.kernelsFolder);
    return {};
}

Result<void> Device::borrow(const LentDevice& lent, VkPhysicalDevice physical) {
    if (!lent.handle || !lent.queue || !physical)
        return Error{ErrorCode::deviceNotUsable, "The program that lends a graphics device gave none.", "",
                     "Give a device, a queue of it, and what it was made of."};
    if (!hasCompute(physical, lent.queueFamily))
        return Error{ErrorCode::usage, "The queue that was lent is of a family that cannot compute.", "",
                     "Give a queue with compute, and the number of its family."};
    // Nobody knows whether these were enabled.
    info_.minSubgroupSize = 0;
    info_.maxSubgroupSize = 0;
    device_ = lent.handle;
    queue_ = lent.queue;
    queueFamily_ = lent.queueFamily;
    queueGuard_ = lent.guard;
    isLent_ = true;
    return {};
}

Result<void> Device::open(const DeviceOptions& options, const std::string& doing) {
    queueFamily_ = *universalQueueFamily(info_.physical);
    std::vector<const char*> extensions = options.extensions;
    extensions.push_back(VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME);
    for (const char* extension : extensions)
        if (!hasExtension(info_.physical, extension))
            return Error{ErrorCode::deviceNotUsable,
                         fmt::format("The device {} does not offer {}.", info_.name, extension), "",
                         "Update its driver, or choose another device with MACULA_DEVICE."};
    // What is good to have: memoryAvailableBytes, and images that other devices share (shared_image.h).
    for (const char* extension :
         {VK_EXT_MEMORY_BUDGET_EXTENSION_NAME, VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME,
          VK_KHR_EXTERNAL_SEMAPHORE_FD_EXTENSION_NAME})
        if (hasExtension(info_.physical, extension)) extensions.push_back(extension);

    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queueInfo{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queueInfo.queueFamilyIndex = queueFamily_;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;

    const Features features(info_.physical);
    VkDeviceCreateInfo deviceInfo{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features.core};
    deviceInfo.queueCreateInfoCount = 1;
    deviceInfo.pQueueCreateInfos = &queueInfo;
    deviceInfo.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    deviceInfo.ppEnabledExtensionNames = extensions.data();
    if (options.givesWay && isCpu()) giveWay(GiveWay::toTheFrame);
    MACULA_VK_TRY(options.createDevice ? options.createDevice(info_.physical, deviceInfo, &device_)
                                       : vkCreateDevice(info_.physical, &deviceInfo, nullptr, &device_),
                  doing);
    vkGetDeviceQueue(device_, queueFamily_, 0, &queue_);
    return {};
}

Device::~Device() {
    if (!device_) return;
    waitUntilIdle();
    for (const Dropped& dropped : dropped_) dropped.destroy(device_, dropped.object);
    staging_->destroyAll(device_);
    kernels_.clear();
    if (pipelineCache_) pipelineCache_->close(!lost());
    for (const Commands& commands : freeCommands_) {
        vkDestroyQueryPool(device_, commands.queries, nullptr);
        vkDestroyCommandPool(device_, commands.pool, nullptr);
    }
    vkDestroySemaphore(device_, timeline_, nullptr);
    if (!isLent_) vkDestroyDevice(device_, nullptr);
}

std::uint64_t Device::memoryAvailableBytes() const {
    return deviceLocalBudget(info_.physical).availableBytes;
}

Ticket Device::completedTicket() const {
    Ticket value = 0;
    if (!lost()) {
        const VkResult result = vkGetSemaphoreCounterValue(device_, timeline_, &value);
        if (result == VK_ERROR_DEVICE_LOST)
            loseIt();
        else if (result < 0)
            return 0;  // nobody knows
    }
    // A lost device runs nothing any more: all is as done as it will ever be.
    return lost() ? submitted_.load() : value;
}

Result<bool> Device::waitFor(Ticket ticket, std::uint64_t timeoutNs) {
    MACULA_CHECK_LE(ticket, submitted_.load());
    MACULA_TRY_VOID(checkNotLost("wait for the graphics device"));
    VkSemaphoreWaitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
    info.semaphoreCount = 1;
    info.pSemaphores = &timeline_;
    info.pValues = &ticket;
    const VkResult result = [&] {
        const TimelineWait wait;
        return vkWaitSemaphores(device_, &info, timeoutNs);
    }();
    if (result < 0) return failed(result, "wait for the graphics device");
    destroyUnused();
    return result == VK_SUCCESS;
}

Result<void> Device::waitForAll() {
    auto done = waitFor(submittedTicket());
    if (!done.ok()) return done.error();
    return {};
}

void destroyLater(Device& device, DestroyFunction destroy, std::uint64_t object) {
    const std::lock_guard lock(device.droppedMutex_);
    // An open recorder may have recorded the object; what it submits has no ticket yet.
    const Ticket after = device.openRecorders_ > 0 ? Device::kNotYetKnown : device.submitted_.load();
    device.dropped_.push_back({destroy, object, after});
}

void Device::recorderClosed() {
    const std::lock_guard lock(droppedMutex_);
    MACULA_CHECK(openRecorders_ > 0);
    if (--openRecorders_ > 0) return;
    for (Dropped& dropped : dropped_)
        if (dropped.after == kNotYetKnown) dropped.after = submitted_.load();
}

bool Device::isFirstStart() const {
    return pipelineCache_ && pipelineCache_->beganEmpty();
}

void Device::destroyUnused() {
    const Ticket completed = completedTicket();
    std::vector<Dropped> due;
    {
        const std::lock_guard lock(droppedMutex_);
        const auto firstKept =
            std::stable_partition(dropped_.begin(), dropped_.end(),
                                  [&](const Dropped& dropped) { return dropped.after <= completed; });
        due.assign(dropped_.begin(), firstKept);
        dropped_.erase(dropped_.begin(), firstKept);
    }
    for (const Dropped& dropped : due)
        dropped.destroy(device_, dropped.object);  // in order: views before images
}

std::size_t Device::pendingDestructions() const {
    const std::lock_guard lock(droppedMutex_);
    return dropped_.size();
}

void Device::setName(VkObjectType type, std::uint64_t object, std::string_view name) const {
    if (!functions_.setObjectName) return;
    const std::string terminated(name);
    VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
    info.objectType = type;
    info.objectHandle = object;
    info.pObjectName = terminated.c_str();
    functions_.setObjectName(device_, &info);
}

void Device::loseIt() const {
    // The work in flight when the device was lost may still end; nothing it uses may be freed before. This
    // returns in finite time on a lost device, too.
    if (!lost_.exchange(true)) waitUntilIdle();
}

// A lost device is idle, too. Of a lent one only what was submitted here is waited for: what else is on its
// queue may wait for its host, which may need the guard to go on.
void Device::waitUntilIdle() const {
    if (!isLent_) {
        vkDeviceWaitIdle(device_);
        return;
    }
    if (!timeline_) return;
    const Ticket last = submitted_.load();
    VkSemaphoreWaitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
    info.semaphoreCount = 1;
    info.pSemaphores = &timeline_;
    info.pValues = &last;
    vkWaitSemaphores(device_, &info, kForever);
}

Result<void> Device::checkNotLost(std::string_view doing) const {
    if (lost()) return vulkanError(VK_ERROR_DEVICE_LOST, doing);
    return {};
}

Error Device::failed(VkResult result, std::string_view doing) const {
    if (result == VK_ERROR_DEVICE_LOST) loseIt();
    return vulkanError(lost() ? VK_ERROR_DEVICE_LOST : result, doing);
}

Result<Device::Commands> Device::makeCommands() {
    Commands commands;
    const auto release = [&](VkResult result) {
        if (commands.queries) vkDestroyQueryPool(device_, commands.queries, nullptr);
        if (commands.pool) vkDestroyCommandPool(device_, commands.pool, nullptr);
        return failed(result, "prepare work for the graphics device");
    };
    VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    poolInfo.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    poolInfo.queueFamilyIndex = queueFamily_;
    if (const VkResult result = vkCreateCommandPool(device_, &poolInfo, nullptr, &commands.pool); result < 0)
        return release(result);

    VkCommandBufferAllocateInfo bufferInfo{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    bufferInfo.commandPool = commands.pool;
    bufferInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    bufferInfo.commandBufferCount = 1;
    if (const VkResult result = vkAllocateCommandBuffers(device_, &bufferInfo, &commands.buffer); result < 0)
        return release(result);

    VkQueryPoolCreateInfo queryInfo{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    queryInfo.queryType = VK_QUERY_TYPE_TIMESTAMP;
    queryInfo.queryCount = 2 * Recorder::kMaxTimers;
    if (const VkResult result = vkCreateQueryPool(device_, &queryInfo, nullptr, &commands.queries);
        result < 0)
        return release(result);
    return commands;
}

Result<Device::Commands> Device::takeCommands() {
    MACULA_TRY_VOID(checkNotLost("prepare work for the graphics device"));
    destroyUnused();
    const Ticket completed = completedTicket();
    const auto idle = std::find_if(freeCommands_.begin(), freeCommands_.end(),
                                   [&](const Commands& commands) { return commands.busyUntil <= completed; });
    Commands commands;
    if (idle != freeCommands_.end()) {
        commands = *idle;
        freeCommands_.erase(idle);
        vkResetCommandPool(device_, commands.pool, 0);
    } else {
        MACULA_TRY(commands, makeCommands());
    }
    const std::lock_guard lock(droppedMutex_);
    ++openRecorders_;
    return commands;
}

void Device::giveCommandsBack(const Commands& commands) {
    freeCommands_.push_back(commands);
}

Result<Ticket> Device::submit(VkCommandBuffer commands, VkSemaphore wait, VkSemaphore signal) {
    MACULA_TRY_VOID(checkNotLost("submit work to the graphics device"));
    const auto semaphoreInfo = [](VkSemaphore semaphore, std::uint64_t value) {
        VkSemaphoreSubmitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
        info.semaphore = semaphore;
        info.value = value;
        info.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
        return info;
    };
    const Ticket ticket = submitted_.load() + 1;
    const VkSemaphoreSubmitInfo waits[] = {semaphoreInfo(wait, 0)};
    const VkSemaphoreSubmitInfo signals[] = {semaphoreInfo(timeline_, ticket), semaphoreInfo(signal, 0)};
    VkCommandBufferSubmitInfo commandsInfo{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    commandsInfo.commandBuffer = commands;
    VkSubmitInfo2 info{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    info.waitSemaphoreInfoCount = wait ? 1 : 0;
    info.pWaitSemaphoreInfos = waits;
    info.commandBufferInfoCount = 1;
    info.pCommandBufferInfos = &commandsInfo;
    info.signalSemaphoreInfoCount = signal ? 2 : 1;
    info.pSignalSemaphoreInfos = signals;
    auto held = queueGuard_ ? std::unique_lock(*queueGuard_) : std::unique_lock<QueueGuard>();
    const VkResult result = vkQueueSubmit2(queue_, 1, &info, VK_NULL_HANDLE);
    if (held) held.unlock();  // a loss waits for the queue
    if (result < 0) return failed(result, "submit work to the graphics device");
    submitted_.store(ticket);
    return ticket;
}

VkInstance Device::instance() const {
    return instance_;
}

}  // namespace macula::gpu
