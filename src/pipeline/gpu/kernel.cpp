#include "pipeline/gpu/kernel.h"

#include <algorithm>

#include "pipeline/gpu/vulkan_error.h"

namespace macula::gpu {
namespace {

void require(bool condition, const char* kernel, const std::string& what) {
    if (!condition) checkFailed(__FILE__, __LINE__, kernel, what);
}

// The shader's constant that is meant; there must be one.
std::uint32_t resolve(const Specialization& wanted, const Reflection& reflection, const char* kernel) {
    for (const ReflectedSpecialization& offered : reflection.specializations)
        if (wanted.name.empty() ? offered.id == wanted.id : offered.name == wanted.name) return offered.id;
    checkFailed(
        __FILE__, __LINE__, kernel,
        fmt::format("the shader has no specialization constant \"{}\" (or id {})", wanted.name, wanted.id));
}

Result<std::shared_ptr<const CompiledKernel>> compile(const std::shared_ptr<Device>& device,
                                                      const ShaderCode& code, const KernelOptions& options,
                                                      const std::string& doing) {
    const auto kernel = std::make_shared<CompiledKernel>(device->handle());
    kernel->name = code.name;
    MACULA_TRY(kernel->reflection, reflectSpirv(code.words));
    const Reflection& reflection = kernel->reflection;

    std::vector<std::uint32_t> values;
    std::vector<VkSpecializationMapEntry> entries;
    for (const Specialization& specialization : options.specializations) {
        entries.push_back({resolve(specialization, reflection, code.name),
                           static_cast<std::uint32_t>(values.size() * sizeof(values[0])), sizeof(values[0])});
        values.push_back(specialization.bits);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const LocalSize& size = reflection.localSize[axis];
        kernel->localSize[axis] = size.value;
        for (std::size_t i = 0; i < entries.size(); ++i)
            if (size.specializationId == entries[i].constantID) kernel->localSize[axis] = values[i];
        require(kernel->localSize[axis] > 0, code.name, "a local size of 0");
    }

    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const ReflectedBinding& reflected : reflection.bindings) {
        require(reflected.set == 0, code.name, fmt::format("{} is not in set 0", reflected.name));
        require(reflected.count == 1, code.name,
                fmt::format("{} is an array of descriptors", reflected.name));
        require(bindings.empty() || bindings.back().binding != reflected.binding, code.name,
                fmt::format("two resources have the binding {}", reflected.binding));
        bindings.push_back({reflected.binding, reflected.type, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    }
    VkDescriptorSetLayoutCreateInfo setInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    setInfo.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
    setInfo.bindingCount = static_cast<std::uint32_t>(bindings.size());
    setInfo.pBindings = bindings.data();
    if (const VkResult result =
            vkCreateDescriptorSetLayout(device->handle(), &setInfo, nullptr, &kernel->setLayout);
        result < 0)
        return device->failed(result, doing);

    const std::uint32_t bytesOfPush = reflection.pushConstants ? reflection.pushConstants->block.bytes : 0;
    const VkPushConstantRange push{VK_SHADER_STAGE_COMPUTE_BIT, 0, bytesOfPush};
    require(push.size % 4 == 0 && push.size <= device->info().maxPushConstantBytes, code.name,
            fmt::format("{} bytes of push constants, and the device allows {}", push.size,
                        device->info().maxPushConstantBytes));
    VkPipelineLayoutCreateInfo layoutInfo{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    layoutInfo.setLayoutCount = 1;
    layoutInfo.pSetLayouts = &kernel->setLayout;
    layoutInfo.pushConstantRangeCount = push.size > 0 ? 1 : 0;
    layoutInfo.pPushConstantRanges = &push;
    if (const VkResult result =
            vkCreatePipelineLayout(device->handle(), &layoutInfo, nullptr, &kernel->layout);
        result < 0)
        return device->failed(result, doing);

    VkShaderModuleCreateInfo moduleInfo{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    moduleInfo.codeSize = code.words.size_bytes();
    moduleInfo.pCode = code.words.data();
    VkShaderModule rawModule = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateShaderModule(device->handle(), &moduleInfo, nullptr, &rawModule);
        result < 0)
        return device->failed(result, doing);
    const Handle<VkShaderModule> module(device, rawModule);  // only needed until the pipeline is made

    const VkSpecializationInfo specialization{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                              values.size() * sizeof(values[0]), values.data()};
    VkComputePipelineCreateInfo pipelineInfo{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    pipelineInfo.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    pipelineInfo.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    pipelineInfo.stage.module = rawModule;
    pipelineInfo.stage.pName = reflection.entryPoint.c_str();
    pipelineInfo.stage.pSpecializationInfo = &specialization;
    VkPipelineShaderStageRequiredSubgroupSizeCreateInfo subgroup{
        VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_REQUIRED_SUBGROUP_SIZE_CREATE_INFO};
    subgroup.requiredSubgroupSize = options.subgroupSize;
    if (options.subgroupSize > 0) {
        require(options.subgroupSize >= device->info().minSubgroupSize &&
                    options.subgroupSize <= device->info().maxSubgroupSize,
                code.name, fmt::format("subgroups of {}", options.subgroupSize));
        pipelineInfo.stage.pNext = &subgroup;
    }
    pipelineInfo.layout = kernel->layout;
    if (const VkResult result = vkCreateComputePipelines(device->handle(), VK_NULL_HANDLE, 1, &pipelineInfo,
                                                         nullptr, &kernel->pipeline);
        result < 0)
        return device->failed(result, doing);
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
    const std::string doing = fmt::format("prepare the shader {}", code.name);
    MACULA_TRY_VOID(device->checkNotLost(doing));
    std::string constants = fmt::format("{};", options.subgroupSize);
    for (const Specialization& constant : options.specializations)
        constants += fmt::format("{}/{}={};", constant.name, constant.id, constant.bits);
    auto& compiled = device->kernels_[{code.words.data(), std::move(constants)}];
    if (!compiled) {
        MACULA_TRY(compiled, compile(device, code, options, doing));
    }
    return Kernel(device, *compiled);
}

}  // namespace macula::gpu
