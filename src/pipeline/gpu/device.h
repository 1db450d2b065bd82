// A device, its queue, and the timeline that says what is done.
#pragma once

#include <vulkan/vulkan_core.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device_info.h"
#include "pipeline/gpu/handle.h"
#include "pipeline/gpu/instance.h"

namespace macula::gpu {

struct CompiledKernel;
class PipelineCache;
class StagingPool;

// The place of a submission on the device's timeline: 1, 2, 3, ... 0 is done from the start.
using Ticket = std::uint64_t;

inline constexpr std::uint64_t kForever = UINT64_MAX;

// The lock of a queue that others use too. As std::mutex: held by one thread at a time, for moments; throws
// nothing.
class QueueGuard {
  public:
    QueueGuard() = default;
    QueueGuard(const QueueGuard&) = delete;
    QueueGuard& operator=(const QueueGuard&) = delete;
    virtual ~QueueGuard() = default;

    virtual void lock() = 0;
    virtual void unlock() = 0;
};

// A device that a host has made of DeviceOptions::physical and destroys after all that is made from it: with
// VK_KHR_push_descriptor, timeline semaphores, scalar block layout, synchronization2 and maintenance4.
struct LentDevice {
    VkDevice handle = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;  // with compute
    std::uint32_t queueFamily = 0;
    // Held while the queue is used; null: the host does not use it meanwhile.
    std::shared_ptr<QueueGuard> guard = nullptr;
};

struct DeviceOptions {
    std::string preferred;                // see chooseDevice; when empty, the environment MACULA_DEVICE
    std::vector<const char*> extensions;  // on top of ours: VK_KHR_SWAPCHAIN_EXTENSION_NAME for a window
    // OpenXR dictates the device (xrGetVulkanGraphicsDevice2KHR) and creates it itself
    // (xrCreateVulkanDeviceKHR).
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    std::function<VkResult(VkPhysicalDevice, const VkDeviceCreateInfo&, VkDevice*)> createDevice;
    std::optional<LentDevice> lent;  // nothing is created
    // Where the driver's compiled kernels are kept for the next start (pipeline_cache.h); made when missing.
    // Empty: no file is read or written. Never of a lent device.
    std::filesystem::path kernelsFolder;
    // Where the device is the processor, this thread and those of the driver let a window's go first
    // (give_way.h), for good. On a card a thread that submits frames must not be late.
    bool givesWay = false;
    // Takes device memory for unmapped, as on a graphics card, to test staging copies without one.
    bool separateMemory = false;
    bool isAnnounced = true;  // log::announce
};

// A VkDevice with one queue for everything (compute, transfer, graphics where there is any).
//
// Held by shared_ptr: each resource keeps its device alive, and the device keeps the VkInstance alive. Thread
// rule: one thread at a time uses a Device, its recorders and its resources; only dropping resources is free
// of that rule.
//
// Lost: after a driver reset every call gives the error deviceLost at once, and lost() is true. To recover,
// drop all that is on the device and create another one: recovery.h.
class Device : public std::enable_shared_from_this<Device> {
  public:
    // Announces the chosen device: who reads a picture or a timing must know what made it.
    // Errors: those of chooseDevice; deviceNotUsable when an extension is missing or the driver refuses.
    static Result<std::shared_ptr<Device>> create(const Instance& instance,
                                                  const DeviceOptions& options = {});

    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device();  // waits for the device

    const DeviceInfo& info() const { return info_; }
    bool isCpu() const { return info_.type == DeviceType::cpu; }
    // Device-local memory is host memory, and mapped.
    bool hasUnifiedMemory() const { return unifiedMemory_; }
    VkInstance instance() const;
    VkPhysicalDevice physical() const { return info_.physical; }
    VkDevice handle() const { return device_; }
    VkQueue queue() const { return queue_; }
    std::uint32_t queueFamily() const { return queueFamily_; }

    // Free device-local memory now, by VK_EXT_memory_budget; the size of the heap where the driver does not
    // tell.
    std::uint64_t memoryAvailableBytes() const;

    Ticket submittedTicket() const { return submitted_.load(); }
    Ticket completedTicket() const;
    // False on timeout. 0 ns polls.
    Result<bool> waitFor(Ticket ticket, std::uint64_t timeoutNs = kForever);
    Result<void> waitForAll();
    bool lost() const { return lost_.load(); }
    // The error deviceLost when the device is lost. Called before anything is created or copied. `doing` as
    // in vulkanError.
    Result<void> checkNotLost(std::string_view doing) const;

    // Bytes read back to the host so far (transfer.h). Tests ask, to prove that drawing a frame reads nothing
    // back.
    std::uint64_t bytesRead() const { return bytesRead_; }
    void countRead(std::uint64_t bytes) { bytesRead_ += bytes; }

    // Whether this version of Macula starts for the first time on this device and driver:
    // DeviceOptions::kernelsFolder holds no pipeline cache (VkPipelineCache) of them. False without a folder.
    bool isFirstStart() const;

    // What transfer.h copies through.
    StagingPool& staging() { return *staging_; }

    // Destroys what was dropped and is no longer in use. Submitting and waiting do it as well.
    void destroyUnused();
    std::size_t pendingDestructions() const;

    // Names an object for validation messages and debuggers; nothing where debug utils are missing.
    void setName(VkObjectType type, std::uint64_t object, std::string_view name) const;

    // Turns a failed call into an Error, and remembers a lost device: whatever fails on one, fails because of
    // that.
    Error failed(VkResult result, std::string_view doing) const;

  private:
    friend class Kernel;
    friend class Recorder;
    friend class Swapchain;
    friend void destroyLater(Device& device, DestroyFunction destroy, std::uint64_t object);

    struct Functions {  // not exported by the loader
        PFN_vkCmdPushDescriptorSetKHR cmdPushDescriptorSet = nullptr;
        PFN_vkSetDebugUtilsObjectNameEXT setObjectName = nullptr;
        PFN_vkCmdBeginDebugUtilsLabelEXT cmdBeginLabel = nullptr;
        PFN_vkCmdEndDebugUtilsLabelEXT cmdEndLabel = nullptr;
    };
    struct Commands {  // what one recording needs; recycled
        VkCommandPool pool = VK_NULL_HANDLE;
        VkCommandBuffer buffer = VK_NULL_HANDLE;
        VkQueryPool queries = VK_NULL_HANDLE;
        Ticket busyUntil = 0;
    };
    struct Dropped {
        DestroyFunction destroy = nullptr;
        std::uint64_t object = 0;
        Ticket after = 0;
    };
    static constexpr Ticket kNotYetKnown = UINT64_MAX;  // dropped while a recorder is open

    Device();
    Result<void> initialise(const Instance& instance, const DeviceOptions& options);
    Result<void> open(const DeviceOptions& options, const std::string& doing);
    Result<void> borrow(const LentDevice& lent, VkPhysicalDevice physical);
    Result<Commands> takeCommands();
    Result<Commands> makeCommands();
    void giveCommandsBack(const Commands& commands);
    void loseIt() const;
    void waitUntilIdle() const;
    void recorderClosed();
    Result<Ticket> submit(VkCommandBuffer commands, VkSemaphore wait, VkSemaphore signal);

    std::shared_ptr<void> instanceState_;
    VkInstance instance_ = VK_NULL_HANDLE;
    DeviceInfo info_;
    bool unifiedMemory_ = false;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    std::uint32_t queueFamily_ = 0;
    bool isLent_ = false;
    std::shared_ptr<QueueGuard> queueGuard_;  // of the host that lends the queue
    double timestampPeriodNs_ = 1.0;
    std::uint32_t timestampBits_ = 0;  // 0: the queue has no timestamps
    std::uint32_t maxGroups_[3] = {0, 0, 0};
    Functions functions_;
    VkSemaphore timeline_ = VK_NULL_HANDLE;
    // The cache of compiled kernels. Its key is the address of the shader's words, which are static data, and
    // its specialization constants as text.
    std::map<std::pair<const std::uint32_t*, std::string>, std::shared_ptr<const CompiledKernel>> kernels_;
    std::unique_ptr<PipelineCache> pipelineCache_;  // null: none is kept on disk
    std::unique_ptr<StagingPool> staging_;
    std::vector<Commands> freeCommands_;
    std::atomic<Ticket> submitted_{0};
    std::uint64_t bytesRead_ = 0;
    mutable std::atomic<bool> lost_{false};  // mutable: a const query may discover the loss

    mutable std::mutex droppedMutex_;  // guards the two below: resources are dropped on any thread
    std::vector<Dropped> dropped_;
    std::size_t openRecorders_ = 0;
};

}  // namespace macula::gpu
