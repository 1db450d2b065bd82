// The connection to the Vulkan loader and its drivers.
#pragma once

#include <vulkan/vulkan_core.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"

namespace macula::gpu {

enum class Validation { off, on };

struct InstanceOptions {
    std::vector<const char*> extensions;      // those of a window system or OpenXR: "VK_KHR_xcb_surface"
    Validation validation = Validation::off;  // the environment MACULA_VALIDATION=1 turns it on, too
    // OpenXR creates the instance itself (xrCreateVulkanInstanceKHR); default vkCreateInstance.
    std::function<VkResult(const VkInstanceCreateInfo&, VkInstance*)> createInstance;
    // An instance that a host program has made for Vulkan 1.3, with `extensions`, and destroys after
    // everything that is made from it. With `validation` on and VK_EXT_debug_utils among `extensions`, its
    // validation messages are collected.
    VkInstance lent = VK_NULL_HANDLE;
};

// The VkInstance and the messages of the validation layer so far. Devices keep it alive, so an Instance may
// be dropped once they are made. Others may adopt the handle (QVulkanInstance::setVkInstance), but must not
// destroy it. Thread-safe.
class Instance {
  public:
    // Fails with deviceNotUsable when there is no Vulkan driver, an extension is missing, or validation is
    // requested and its layer is not installed.
    static Result<Instance> create(const InstanceOptions& options = {});

    Instance(Instance&&) noexcept = default;
    Instance& operator=(Instance&&) noexcept = default;

    VkInstance handle() const;
    bool validating() const;
    bool hasDebugUtils() const;  // object names and labels reach debuggers such as RenderDoc

    // Warnings and errors of the validation layer since the start; each was also logged. A test suite expects
    // 0.
    std::size_t validationMessageCount() const;
    std::vector<std::string> validationMessages() const;

  private:
    friend class Device;
    struct State;

    explicit Instance(std::shared_ptr<State> state) : state_(std::move(state)) {}
    static Result<Instance> borrow(const InstanceOptions& options);
    static Result<Instance> finished(std::shared_ptr<State> state);

    std::shared_ptr<State> state_;
};

}  // namespace macula::gpu
