// The class that owns Vulkan objects. All other classes of this folder follow the rule of zero on top of it.
#pragma once

#include <vulkan/vulkan_core.h>

#include <bit>
#include <cstdint>
#include <memory>
#include <utility>

namespace macula::gpu {

class Device;

using DestroyFunction = void (*)(VkDevice, std::uint64_t object);

// Destroys the object once all work that may use it is done: everything submitted so far, and everything that
// the recorders open now will submit. Thread-safe.
void destroyLater(Device& device, DestroyFunction destroy, std::uint64_t object);

// vkDestroyX for each X. Non-dispatchable handles are distinct pointer types on every 64-bit platform.
static_assert(sizeof(void*) == 8, "Vulkan handles are told apart by type, which needs a 64-bit platform");
inline void destroyNow(VkDevice device, VkBuffer object) {
    vkDestroyBuffer(device, object, nullptr);
}
inline void destroyNow(VkDevice device, VkBufferView object) {
    vkDestroyBufferView(device, object, nullptr);
}
inline void destroyNow(VkDevice device, VkImage object) {
    vkDestroyImage(device, object, nullptr);
}
inline void destroyNow(VkDevice device, VkImageView object) {
    vkDestroyImageView(device, object, nullptr);
}
inline void destroyNow(VkDevice device, VkSampler object) {
    vkDestroySampler(device, object, nullptr);
}
inline void destroyNow(VkDevice device, VkDeviceMemory object) {
    vkFreeMemory(device, object, nullptr);
}
inline void destroyNow(VkDevice device, VkPipeline object) {
    vkDestroyPipeline(device, object, nullptr);
}
inline void destroyNow(VkDevice device, VkPipelineLayout object) {
    vkDestroyPipelineLayout(device, object, nullptr);
}
inline void destroyNow(VkDevice device, VkDescriptorSetLayout object) {
    vkDestroyDescriptorSetLayout(device, object, nullptr);
}
inline void destroyNow(VkDevice device, VkShaderModule object) {
    vkDestroyShaderModule(device, object, nullptr);
}
inline void destroyNow(VkDevice device, VkSemaphore object) {
    vkDestroySemaphore(device, object, nullptr);
}

// Move-only owner; keeps its Device alive. May be dropped on any thread and at any time, also while the GPU
// uses the object.
template <class VkObject>
class Handle {
  public:
    Handle() = default;
    Handle(std::shared_ptr<Device> device, VkObject object) : device_(std::move(device)), object_(object) {}
    Handle(Handle&& other) noexcept
        : device_(std::move(other.device_)), object_(std::exchange(other.object_, VkObject{})) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(object_, other.object_);
        return *this;
    }
    ~Handle() {
        if (object_) destroyLater(*device_, &destroyErased, std::bit_cast<std::uint64_t>(object_));
    }

    VkObject get() const { return object_; }
    // Gives up ownership: the caller destroys the object.
    VkObject release() {
        device_.reset();
        return std::exchange(object_, VkObject{});
    }
    explicit operator bool() const { return object_ != VkObject{}; }
    const std::shared_ptr<Device>& device() const { return device_; }

  private:
    static void destroyErased(VkDevice device, std::uint64_t object) {
        destroyNow(device, std::bit_cast<VkObject>(object));
    }

    std::shared_ptr<Device> device_;
    VkObject object_{};
};

}  // namespace macula::gpu
