// A compute shader ready to run.
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/handle.h"
#include "pipeline/gpu/shader_code.h"
#include "pipeline/gpu/spirv_reflection.h"

namespace macula::gpu {

// The value of a specialization constant: `{"kMaxBounces", 4u}`, or by id for local_size_x_id: `{0, 64u}`.
struct Specialization {
    Specialization(std::string_view constantName, auto constantValue)
        : name(constantName), bits(bitsOf(constantValue)) {}
    Specialization(std::uint32_t constantId, auto constantValue)
        : id(constantId), bits(bitsOf(constantValue)) {}

    std::string_view name;  // when empty, by id
    std::uint32_t id = 0;
    std::uint32_t bits = 0;

  private:
    static std::uint32_t bitsOf(bool value) { return value ? VK_TRUE : VK_FALSE; }
    template <class T>
    requires(!std::same_as<T, bool> && sizeof(T) == 4) static std::uint32_t bitsOf(T value) {
        std::uint32_t result = 0;
        std::memcpy(&result, &value, sizeof(result));
        return result;
    }
};

struct KernelOptions {
    std::vector<Specialization>
        specializations;  // a variant of the shader; a name it does not have is a failed check
};

// Equivalent of a compute VkPipeline and its layouts, which come from reflection. All bindings are in set 0,
// pushed at each dispatch, so there are no descriptor sets to manage. Movable; may be dropped at any time.
class Kernel {
  public:
    static Result<Kernel> create(const std::shared_ptr<Device>& device, const ShaderCode& code,
                                 const KernelOptions& options = {});

    const std::string& name() const { return name_; }
    const std::array<std::uint32_t, 3>& localSize() const { return localSize_; }
    const Reflection& reflection() const { return reflection_; }
    std::uint32_t pushConstantBytes() const {
        return reflection_.pushConstants ? reflection_.pushConstants->block.bytes : 0;
    }

    VkPipeline pipeline() const { return pipeline_.get(); }
    VkPipelineLayout layout() const { return layout_.get(); }

  private:
    Kernel() = default;

    std::string name_;
    Reflection reflection_;
    std::array<std::uint32_t, 3> localSize_{1, 1, 1};
    Handle<VkDescriptorSetLayout> setLayout_;
    Handle<VkPipelineLayout> layout_;
    Handle<VkPipeline> pipeline_;
};

}  // namespace macula::gpu
