#include "pipeline/gpu/device.h"

#include <algorithm>
#include <cstdlib>

#include "base/check.h"
#include "base/log.h"
#include "base/timeline.h"
#include "pipeline/gpu/instance_state.h"
#include "pipeline/gpu/physical_device.h"
#include "pipeline/gpu/pipeline_cache.h"
#include "pipeline/gpu/staging_pool.h"
#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {

namespace {

bool environmentAllowsNativeKernels() {
    const char* value = std::getenv("MACULA_NATIVE_KERNELS");
    return value == nullptr || std::string_view(value) != "off";
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
    MACULA_TRY(info_, chosenDevice(instance, options));
    unifiedMemory_ = (isCpu() || info_.type == DeviceType::integrated) && !options.separateMemory;
    nativeKernels_ = isCpu() && unifiedMemory_ && options.nativeKernels && environmentAllowsNativeKernels();
    const Text doing = Text("open the device {}", info_.name);
    if (options.lent) {
        MACULA_TRY(opened_, borrowDevice(*options.lent, options.physical));
        // A host may not have enabled subgroup size control, and Vulkan cannot be asked.
        info_.minSubgroupSize = 0;
        info_.maxSubgroupSize = 0;
    } else {
        MACULA_TRY(opened_, openDevice(info_, options, doing));
    }
    MACULA_TRY_VOID(loadFunctions(instance.hasDebugUtils()));

    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(info_.physical, &properties);
    timestampPeriodNs_ = properties.limits.timestampPeriod;
    timestampBits_ = timestampBits(info_.physical, opened_.queueFamily);
    std::copy_n(properties.limits.maxComputeWorkGroupCount, 3, maxGroups_);

    VkSemaphoreTypeCreateInfo timeline{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
    timeline.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
    const VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, &timeline, 0};
    MACULA_VK_TRY(vkCreateSemaphore(opened_.handle, &semaphore, nullptr, &timeline_), doing);
    setName(VK_OBJECT_TYPE_SEMAPHORE, reinterpret_cast<std::uint64_t>(timeline_), "timeline");
    // No cache file for a lent device: files are the host's business.
    if (!options.kernelsFolder.empty() && !opened_.isLent)
        pipelineCache_ = PipelineCache::open(opened_.handle, info_.physical, options.kernelsFolder);
    return {};
}

Result<void> Device::loadFunctions(bool hasDebugUtils) {
    const auto load = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
            vkGetDeviceProcAddr(handle(), name));
    };
    load(functions_.cmdPushDescriptorSet, "vkCmdPushDescriptorSetKHR");
    if (!functions_.cmdPushDescriptorSet)
        return Error{ErrorCode::deviceNotUsable,
                     Text("The device {} was opened without what Macula needs of it.", info_.name), "",
                     Text("Open it with VK_KHR_push_descriptor.")};
    if (!hasDebugUtils) return {};
    load(functions_.setObjectName, "vkSetDebugUtilsObjectNameEXT");
    load(functions_.cmdBeginLabel, "vkCmdBeginDebugUtilsLabelEXT");
    load(functions_.cmdEndLabel, "vkCmdEndDebugUtilsLabelEXT");
    return {};
}

Device::~Device() {
    if (!opened_.handle) return;
    waitUntilIdle();
    dropped_.destroyAll(opened_.handle);
    staging_->destroyAll(opened_.handle);
    kernels_.clear();
    if (pipelineCache_) pipelineCache_->close(!lost());
    commands_.destroyAll(opened_.handle);
    vkDestroySemaphore(opened_.handle, timeline_, nullptr);
    if (!opened_.isLent) vkDestroyDevice(opened_.handle, nullptr);
}

std::uint64_t Device::memoryAvailableBytes() const {
    return deviceLocalBudget(info_.physical).availableBytes;
}

Ticket Device::completedTicket() const {
    Ticket value = 0;
    if (!lost()) {
        const VkResult result = vkGetSemaphoreCounterValue(opened_.handle, timeline_, &value);
        if (result == VK_ERROR_DEVICE_LOST)
            loseIt();
        else if (result < 0)
            return 0;  // unknown: counts as nothing done
    }
    // A lost device runs nothing any more: all submissions count as completed.
    return lost() ? submitted_.load() : value;
}

Result<bool> Device::waitFor(Ticket ticket, std::uint64_t timeoutNs) {
    MACULA_CHECK_LE(ticket, submitted_.load());
    // Made before the call: after it, failed() has to note a loss before anything needs memory.
    const Text doing("wait for the graphics device");
    MACULA_TRY_VOID(checkNotLost(doing));
    VkSemaphoreWaitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
    info.semaphoreCount = 1;
    info.pSemaphores = &timeline_;
    info.pValues = &ticket;
    const VkResult result = [&] {
        const TimelineWait wait;
        return vkWaitSemaphores(opened_.handle, &info, timeoutNs);
    }();
    if (result < 0) return failed(result, doing);
    destroyUnused();
    return result == VK_SUCCESS;
}

Result<void> Device::waitForAll() {
    auto done = waitFor(submittedTicket());
    if (!done.ok()) return done.error();
    return {};
}

void destroyLater(Device& device, DestroyFunction destroy, std::uint64_t object) {
    device.dropped_.add(destroy, object, device.submitted_);
}

bool Device::isFirstStart() const {
    return pipelineCache_ && pipelineCache_->beganEmpty();
}

void Device::destroyUnused() {
    dropped_.destroyDone(opened_.handle, completedTicket());
}

void Device::setName(VkObjectType type, std::uint64_t object, std::string_view name) const {
    if (!functions_.setObjectName) return;
    const std::string terminated(name);
    VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
    info.objectType = type;
    info.objectHandle = object;
    info.pObjectName = terminated.c_str();
    functions_.setObjectName(opened_.handle, &info);
}

void Device::loseIt() const {
    // Work in flight when the device was lost may still be ending, and nothing that it uses may be freed
    // before. This wait returns in finite time on a lost device, too.
    if (!lost_.exchange(true)) waitUntilIdle();
}

// Works on a lost device, too. On a lent device, waits only for Macula's own submissions: other work on its
// queue may wait for its host, which may need the guard to continue.
void Device::waitUntilIdle() const {
    if (!opened_.isLent) {
        vkDeviceWaitIdle(opened_.handle);
        return;
    }
    if (!timeline_) return;
    const Ticket last = submitted_.load();
    VkSemaphoreWaitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
    info.semaphoreCount = 1;
    info.pSemaphores = &timeline_;
    info.pValues = &last;
    vkWaitSemaphores(opened_.handle, &info, kForever);
}

Result<void> Device::checkNotLost(const Text& doing) const {
    if (lost()) return vulkanError(VK_ERROR_DEVICE_LOST, doing);
    return {};
}

Error Device::failed(VkResult result, const Text& doing) const {
    if (result == VK_ERROR_DEVICE_LOST) loseIt();
    return vulkanError(lost() ? VK_ERROR_DEVICE_LOST : result, doing);
}

Result<CommandPool::Commands> Device::takeCommands() {
    const Text doing = Text("prepare work for the graphics device");
    MACULA_TRY_VOID(checkNotLost(doing));
    destroyUnused();
    CommandPool::Commands commands;
    if (const VkResult result =
            commands_.take(opened_.handle, opened_.queueFamily, completedTicket(), commands);
        result < 0)
        return failed(result, doing);
    return commands;
}

Result<Ticket> Device::submit(VkCommandBuffer commands, VkSemaphore wait, VkSemaphore signal) {
    const Text doing("submit work to the graphics device");  // made before the call, as in waitFor()
    MACULA_TRY_VOID(checkNotLost(doing));
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
    auto held = opened_.guard ? std::unique_lock(*opened_.guard) : std::unique_lock<QueueGuard>();
    const VkResult result = vkQueueSubmit2(opened_.queue, 1, &info, VK_NULL_HANDLE);
    if (held) held.unlock();  // before failed(), which waits for the queue after a loss
    if (result < 0) return failed(result, doing);
    submitted_.store(ticket);
    return ticket;
}

VkInstance Device::instance() const {
    return instance_;
}

}  // namespace macula::gpu
