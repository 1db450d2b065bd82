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
    std::vector<const char*> extensions;      // what a window system or OpenXR needs: "VK_KHR_xcb_surface"
    Validation validation = Validation::off;  // the environment MACULA_VALIDATION=1 turns it on, too
    // OpenXR creates the instance itself (xrCreateVulkanInstanceKHR); default vkCreateInstance.
    std::function<VkResult(const VkInstanceCreateInfo&, VkInstance*)> createInstance;
    // An instance that a host has made for Vulkan 1.3, with `extensions`, and destroys after all that is made
    // from this. Whether it validates, the host knows: then VK_EXT_debug_utils makes us hear of it.
    VkInstance lent = VK_NULL_HANDLE;
};

// The VkInstance and what the validation layer said so far. Devices keep it alive, so an Instance may be
// dropped once they are made. The handle may be adopted by others (QVulkanInstance::setVkInstance); they must
// not destroy it. Thread-safe.
class Instance {
  public:
    // deviceNotUsable when there is no Vulkan driver, an extension is missing, or validation is wanted and
    // its layer is not installed.
    static Result<Instance> create(const InstanceOptions& options = {});

    Instance(Instance&&) noexcept = default;
    Instance& operator=(Instance&&) noexcept = default;

    VkInstance handle() const;
    bool validating() const;
    bool hasDebugUtils() const;  // object names and labels reach debuggers such as RenderDoc

    // Warnings and errors of the validation layer since the start, also logged when they came. A test suite
    // expects 0.
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
