#include "pipeline/gpu/kernel.h"

#include <algorithm>

#include "pipeline/gpu/pipeline_cache.h"
#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {
namespace {

void require(bool condition, const char* kernel, const std::string& what) {
    if (!condition) checkFailed(__FILE__, __LINE__, kernel, what);
}

// The id of the requested specialization constant; the shader must have it.
std::uint32_t resolve(const Specialization& wanted, const Reflection& reflection, const char* kernel) {
    for (const ReflectedSpecialization& offered : reflection.specializations)
        if (wanted.name.empty() ? offered.id == wanted.id : offered.name == wanted.name) return offered.id;
    checkFailed(
        __FILE__, __LINE__, kernel,
        fmt::format("the shader has no specialization constant \"{}\" (or id {})", wanted.name, wanted.id));
}

// The values of specialization constants in Vulkan's form.
struct SpecializationData {
    std::vector<std::uint32_t> values;
    std::vector<VkSpecializationMapEntry> entries;

    VkSpecializationInfo info() const {
        return {static_cast<std::uint32_t>(entries.size()), entries.data(), values.size() * sizeof(values[0]),
                values.data()};
    }
};

SpecializationData specialized(const KernelOptions& options, const Reflection& reflection, const char* name) {
    SpecializationData data;
    for (const Specialization& specialization : options.specializations) {
        data.entries.push_back({resolve(specialization, reflection, name),
                                static_cast<std::uint32_t>(data.values.size() * sizeof(data.values[0])),
                                sizeof(data.values[0])});
        data.values.push_back(specialization.bits);
    }
    return data;
}

void setLocalSize(CompiledKernel& kernel, const SpecializationData& constants, const char* name) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const LocalSize& size = kernel.reflection.localSize[axis];
        kernel.localSize[axis] = size.value;
        for (std::size_t i = 0; i < constants.entries.size(); ++i)
            if (size.specializationId == constants.entries[i].constantID)
                kernel.localSize[axis] = constants.values[i];
        require(kernel.localSize[axis] > 0, name, "a local size of 0");
    }
}

// Creates the layout of the one set of push descriptors, with a single resource at each binding.
VkResult createSetLayout(CompiledKernel& kernel, const char* name) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const ReflectedBinding& reflected : kernel.reflection.bindings) {
        require(reflected.set == 0, name, fmt::format("{} is not in set 0", reflected.name));
        require(reflected.count == 1, name, fmt::format("{} is an array of descriptors", reflected.name));
        require(bindings.empty() || bindings.back().binding != reflected.binding, name,
                fmt::format("two resources have the binding {}", reflected.binding));
        bindings.push_back({reflected.binding, reflected.type, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    }
    VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    info.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
    info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    return vkCreateDescriptorSetLayout(kernel.device, &info, nullptr, &kernel.setLayout);
}

VkResult createPipelineLayout(CompiledKernel& kernel, const DeviceInfo& device, const char* name) {
    const auto& reflected = kernel.reflection.pushConstants;
    const VkPushConstantRange push{VK_SHADER_STAGE_COMPUTE_BIT, 0, reflected ? reflected->block.bytes : 0};
    require(push.size % 4 == 0 && push.size <= device.maxPushConstantBytes, name,
            fmt::format("{} bytes of push constants, and the device allows {}", push.size,
                        device.maxPushConstantBytes));
    VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = 1;
    info.pSetLayouts = &kernel.setLayout;
    info.pushConstantRangeCount = push.size > 0 ? 1 : 0;
    info.pPushConstantRanges = &push;
    return vkCreatePipelineLayout(kernel.device, &info, nullptr, &kernel.layout);
}

VkResult createPipeline(CompiledKernel& kernel, const DeviceInfo& device, const KernelOptions& options,
                        const SpecializationData& constants, VkShaderModule module, VkPipelineCache cache,
                        const char* name) {
    const VkSpecializationInfo specialization = constants.info();
    VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = kernel.reflection.entryPoint.c_str();
    info.stage.pSpecializationInfo = &specialization;
    VkPipelineShaderStageRequiredSubgroupSizeCreateInfo subgroup{
        VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_REQUIRED_SUBGROUP_SIZE_CREATE_INFO};
    subgroup.requiredSubgroupSize = options.subgroupSize;
    if (options.subgroupSize > 0) {
        require(
            options.subgroupSize >= device.minSubgroupSize && options.subgroupSize <= device.maxSubgroupSize,
            name, fmt::format("subgroups of {}", options.subgroupSize));
        info.stage.pNext = &subgroup;
    }
    info.layout = kernel.layout;
    return vkCreateComputePipelines(kernel.device, cache, 1, &info, nullptr, &kernel.pipeline);
}

Result<std::shared_ptr<const CompiledKernel>> compile(const std::shared_ptr<Device>& device,
                                                      const ShaderCode& code, const KernelOptions& options,
                                                      VkPipelineCache cache, const Text& doing) {
    const auto kernel = std::make_shared<CompiledKernel>(device->handle());
    kernel->name = code.name;
    MACULA_TRY(kernel->reflection, reflectSpirv(code.words));
    const SpecializationData constants = specialized(options, kernel->reflection, code.name);
    setLocalSize(*kernel, constants, code.name);
    if (device->runsNatively() && options.native) {
        kernel->native = options.native;
        return std::shared_ptr<const CompiledKernel>(kernel);
    }
    if (const VkResult status = createSetLayout(*kernel, code.name); status < 0)
        return device->failed(status, doing);
    if (const VkResult status = createPipelineLayout(*kernel, device->info(), code.name); status < 0)
        return device->failed(status, doing);

    VkShaderModuleCreateInfo moduleInfo{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    moduleInfo.codeSize = code.words.size_bytes();
    moduleInfo.pCode = code.words.data();
    VkShaderModule rawModule = VK_NULL_HANDLE;
    if (const VkResult status = vkCreateShaderModule(device->handle(), &moduleInfo, nullptr, &rawModule);
        status < 0)
        return device->failed(status, doing);
    const Handle<VkShaderModule> module(device, rawModule);  // only needed until the pipeline is made

    if (const VkResult status =
            createPipeline(*kernel, device->info(), options, constants, module.get(), cache, code.name);
        status < 0)
        return device->failed(status, doing);
    device->setName(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(kernel->pipeline), code.name);
    return std::shared_ptr<const CompiledKernel>(kernel);
}

}  // namespace

CompiledKernel::~CompiledKernel() {
    vkDestroyPipeline(device, pipeline, nullptr);
    vkDestroyPipelineLayout(device, layout, nullptr);
    vkDestroyDescriptorSetLayout(device, setLayout, nullptr);
}

Result<Kernel> Kernel::create(const std::shared_ptr<Device>& device, const ShaderCode& code,
                              const KernelOptions& options) {
    MACULA_CHECK(device != nullptr);
    const Text doing = Text("prepare the shader {}", code.name);
    MACULA_TRY_VOID(device->checkNotLost(doing));
    std::string constants =
        fmt::format("{};{};", options.subgroupSize, device->runsNatively() && options.native ? "host" : "");
    for (const Specialization& constant : options.specializations)
        constants += fmt::format("{}/{}={};", constant.name, constant.id, constant.bits);
    auto& compiled = device->kernels_[{code.words.data(), std::move(constants)}];
    if (!compiled) {
        const VkPipelineCache cache =
            device->pipelineCache_ ? device->pipelineCache_->handle() : VkPipelineCache{VK_NULL_HANDLE};
        MACULA_TRY(compiled, compile(device, code, options, cache, doing));
    }
    return Kernel(device, *compiled);
}

void Kernel::requireFit(std::span<const std::byte> push, std::span<const Binding> bindings,
                        const std::string& label) const {
    const auto requireIt = [&](bool fits, const std::string& what) {
        require(fits, label.c_str(), name() + ": " + what);
    };
    requireIt(push.size() == pushConstantBytes(),
              fmt::format("the shader has {} bytes of push constants, the call {}", pushConstantBytes(),
                          push.size()));
    requireIt(bindings.size() == reflection().bindings.size(),
              fmt::format("the shader has {} bindings, the call {}", reflection().bindings.size(),
                          bindings.size()));
    for (std::size_t i = 0; i < bindings.size(); ++i) {
        const ReflectedBinding& wanted = reflection().bindings[i];
        requireIt(
            bindings[i].fits(wanted.type),
            fmt::format("\"{}\" cannot be bound to {} (binding {}): it is of another kind, or lacks the "
                        "usage",
                        *bindings[i].label_, wanted.name, wanted.binding));
    }
}

}  // namespace macula::gpu
