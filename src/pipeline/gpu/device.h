// A device, its queue, and the timeline semaphore that tells which submissions are done.
#pragma once

#include <vulkan/vulkan_core.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "pipeline/gpu/command_pool.h"
#include "pipeline/gpu/device_info.h"
#include "pipeline/gpu/device_opening.h"
#include "pipeline/gpu/device_options.h"
#include "pipeline/gpu/dropped_objects.h"
#include "pipeline/gpu/handle.h"
#include "pipeline/gpu/instance.h"
#include "pipeline/gpu/ticket.h"

namespace macula::gpu {

struct CompiledKernel;
class PipelineCache;
class StagingPool;

inline constexpr std::uint64_t kForever = UINT64_MAX;

// A VkDevice with one queue for everything (compute, transfer, graphics where there is any).
//
// Held by shared_ptr: each resource keeps its device alive, and the device keeps the VkInstance alive. Thread
// rule: one thread at a time uses a Device, its recorders and its resources; only dropping resources is
// exempt.
//
// Lost: after a driver reset every call fails with deviceLost at once, and lost() is true. To recover, drop
// everything that is on the device and create another one: recovery.h.
class Device : public std::enable_shared_from_this<Device> {
  public:
    // Announces the chosen device: whoever reads a picture or a timing must know which device made it.
    // Errors: those of chooseDevice; deviceNotUsable when an extension is missing or the driver refuses.
    static Result<std::shared_ptr<Device>> create(const Instance& instance,
                                                  const DeviceOptions& options = {});

    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device();  // waits for the device

    const DeviceInfo& info() const { return info_; }
    bool isCpu() const { return info_.type == DeviceType::cpu; }
    // Whether device-local memory is host memory, and mapped.
    bool hasUnifiedMemory() const { return unifiedMemory_; }
    // Whether kernels that have a twin on the host (native_kernel.h) run there.
    bool runsNatively() const { return nativeKernels_; }
    VkInstance instance() const;
    VkPhysicalDevice physical() const { return info_.physical; }
    VkDevice handle() const { return opened_.handle; }
    VkQueue queue() const { return opened_.queue; }
    std::uint32_t queueFamily() const { return opened_.queueFamily; }

    // Free device-local memory now, by VK_EXT_memory_budget; the size of the heap if the driver does not
    // report it.
    std::uint64_t memoryAvailableBytes() const;

    Ticket submittedTicket() const { return submitted_.load(); }
    Ticket completedTicket() const;
    // False on timeout. 0 ns polls.
    Result<bool> waitFor(Ticket ticket, std::uint64_t timeoutNs = kForever);
    Result<void> waitForAll();
    bool lost() const { return lost_.load(); }
    // Fails with deviceLost when the device is lost. Called before anything is created or copied. `doing` as
    // in vulkanError.
    Result<void> checkNotLost(const Text& doing) const;

    // Bytes read back to the host so far (transfer.h). Tests use this to prove that drawing a frame reads
    // nothing back.
    std::uint64_t bytesRead() const { return bytesRead_; }
    void countRead(std::uint64_t bytes) { bytesRead_ += bytes; }

    // Whether this version of Macula starts for the first time on this device and driver:
    // DeviceOptions::kernelsFolder then holds no pipeline cache (VkPipelineCache) for them. False without a
    // folder.
    bool isFirstStart() const;

    // The host memory through which transfer.h copies.
    StagingPool& staging() { return *staging_; }

    // Destroys the dropped objects that the device no longer uses. Submitting and waiting do so as well.
    void destroyUnused();
    std::size_t pendingDestructions() const { return dropped_.count(); }

    // Names an object for validation messages and debuggers; does nothing without debug utils.
    void setName(VkObjectType type, std::uint64_t object, std::string_view name) const;

    // Turns a failed call into an Error, and notes a loss of the device. On a lost device every failure is
    // reported as deviceLost, its cause.
    Error failed(VkResult result, const Text& doing) const;

  private:
    friend class Kernel;
    friend class Recorder;
    friend class Swapchain;
    friend void destroyLater(Device& device, DestroyFunction destroy, std::uint64_t object);

    struct Functions {  // extension functions, which the loader does not export
        PFN_vkCmdPushDescriptorSetKHR cmdPushDescriptorSet = nullptr;
        PFN_vkSetDebugUtilsObjectNameEXT setObjectName = nullptr;
        PFN_vkCmdBeginDebugUtilsLabelEXT cmdBeginLabel = nullptr;
        PFN_vkCmdEndDebugUtilsLabelEXT cmdEndLabel = nullptr;
    };
    Device();
    Result<void> initialise(const Instance& instance, const DeviceOptions& options);
    Result<void> loadFunctions(bool hasDebugUtils);
    // Commands for a recording, until giveCommandsBack(); a recording with native kernels takes several.
    Result<CommandPool::Commands> takeCommands();
    void giveCommandsBack(const CommandPool::Commands& commands) { commands_.give(commands); }
    void loseIt() const;
    void waitUntilIdle() const;
    void recorderClosed() { dropped_.recorderClosed(submitted_); }
    Result<Ticket> submit(VkCommandBuffer commands, VkSemaphore wait, VkSemaphore signal);

    std::shared_ptr<void> instanceState_;
    VkInstance instance_ = VK_NULL_HANDLE;
    DeviceInfo info_;
    bool unifiedMemory_ = false;
    bool nativeKernels_ = false;
    OpenedDevice opened_;
    double timestampPeriodNs_ = 1.0;
    std::uint32_t timestampBits_ = 0;  // 0: the queue has no timestamps
    std::uint32_t maxGroups_[3] = {0, 0, 0};
    Functions functions_;
    VkSemaphore timeline_ = VK_NULL_HANDLE;
    // The cache of compiled kernels. Its key is the address of the shader's words, which are static data, and
    // its specialization constants as text.
    std::map<std::pair<const std::uint32_t*, std::string>, std::shared_ptr<const CompiledKernel>> kernels_;
    std::unique_ptr<PipelineCache> pipelineCache_;  // null: compiled kernels are not kept on disk
    std::unique_ptr<StagingPool> staging_;
    CommandPool commands_;
    std::atomic<Ticket> submitted_{0};
    std::uint64_t bytesRead_ = 0;
    mutable std::atomic<bool> lost_{false};  // mutable: a const query may discover the loss
    DroppedObjects dropped_;
};

}  // namespace macula::gpu
