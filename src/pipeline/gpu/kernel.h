// A compute shader ready to run.
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/binding.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/native_kernel.h"
#include "pipeline/gpu/shader_code.h"
#include "pipeline/gpu/spirv_reflection.h"

namespace macula::gpu {

// The value of a specialization constant: `{"kMaxBounces", 4u}`, or by id for local_size_x_id: `{0, 64u}`.
struct Specialization {
    Specialization(std::string_view constantName, auto constantValue)
        : name(constantName), bits(bitsOf(constantValue)) {}
    Specialization(std::uint32_t constantId, auto constantValue)
        : id(constantId), bits(bitsOf(constantValue)) {}

    std::string_view name;  // when empty, `id` counts
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
        specializations;  // choose a variant of the shader; an unknown name is a failed check
    // The subgroup size that the kernel requires: a power of two from DeviceInfo::minSubgroupSize to
    // maxSubgroupSize. 0: the driver chooses, perhaps another than DeviceInfo::subgroupSize.
    std::uint32_t subgroupSize = 0;
    // Does the same as the shader, on the host; depends on nothing but these constants. May be empty.
    NativeKernel native = {};
};

// A compiled pipeline. The device caches it as long as the device lives: another Kernel of the same shader
// and constants is not compiled again.
struct CompiledKernel {
    explicit CompiledKernel(VkDevice on) : device(on) {}
    CompiledKernel(const CompiledKernel&) = delete;
    CompiledKernel& operator=(const CompiledKernel&) = delete;
    ~CompiledKernel();

    VkDevice device;
    std::string name;
    Reflection reflection;
    std::array<std::uint32_t, 3> localSize{1, 1, 1};
    VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkPipeline pipeline = VK_NULL_HANDLE;
    NativeKernel native;  // runs instead of the pipeline, which is then missing; may be empty
};

// Equivalent of a compute VkPipeline and its layouts, which come from reflection. All bindings are in set 0,
// pushed at each dispatch, so there are no descriptor sets to manage. May be copied, and dropped at any time.
class Kernel {
  public:
    static Result<Kernel> create(const std::shared_ptr<Device>& device, const ShaderCode& code,
                                 const KernelOptions& options = {});

    const std::string& name() const { return compiled_->name; }
    const std::array<std::uint32_t, 3>& localSize() const { return compiled_->localSize; }
    const Reflection& reflection() const { return compiled_->reflection; }
    std::uint32_t pushConstantBytes() const {
        return reflection().pushConstants ? reflection().pushConstants->block.bytes : 0;
    }

    // A failed check, which names the recording `label`, unless these match the shader.
    void requireFit(std::span<const std::byte> push, std::span<const Binding> bindings,
                    const std::string& label) const;

    // Not empty if the kernel runs on the host.
    const NativeKernel& native() const { return compiled_->native; }
    VkPipeline pipeline() const { return compiled_->pipeline; }
    VkPipelineLayout layout() const { return compiled_->layout; }

  private:
    Kernel(std::shared_ptr<Device> device, const CompiledKernel& compiled)
        : device_(std::move(device)), compiled_(&compiled) {}

    std::shared_ptr<Device> device_;  // its cache owns what compiled_ points to
    const CompiledKernel* compiled_;
};

}  // namespace macula::gpu
