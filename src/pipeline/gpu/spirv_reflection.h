// Reads the interface of a compute shader from its SPIR-V.
//
// Written by hand, because the SPIRV-Cross of Debian 12 does not accept SPIR-V 1.6. Covers the SPIR-V that
// glslang 12 makes from our shaders; needs debug names (do not strip).
#pragma once

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace macula::gpu {

struct ReflectedMember {
    std::string name;
    std::uint32_t offset = 0;       // bytes from the start of the enclosing struct
    std::uint32_t bytes = 0;        // without trailing padding; 0 for an array of run-time length
    std::uint32_t arrayStride = 0;  // 0 unless an array
    std::uint32_t arrayLength = 0;  // 0 unless an array of fixed length
    std::uint32_t matrixStride = 0;
    std::vector<ReflectedMember> members;  // of a struct, or of the elements of an array of structs

    const ReflectedMember* find(std::string_view memberName) const;
};

// A binding to a resource, or the push constants (then `type` is meaningless).
struct ReflectedBinding {
    std::string name;  // name of the variable, else of the block
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    std::uint32_t count = 1;  // descriptors; 0 for a run-time length
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
    ReflectedMember block;  // for buffers and push constants: the whole struct
};

struct ReflectedSpecialization {
    std::string name;  // empty if it has none: local_size_x_id
    std::uint32_t id = 0;
    std::uint32_t defaultBits = 0;
};

struct LocalSize {
    std::uint32_t value = 1;
    std::optional<std::uint32_t> specializationId;  // when set, `value` is its default
};

struct Reflection {
    std::string entryPoint;
    std::array<LocalSize, 3> localSize;
    std::optional<ReflectedBinding> pushConstants;
    std::vector<ReflectedBinding> bindings;  // sorted by set, then binding
    std::vector<ReflectedSpecialization> specializations;
};

// Fails with inputNotUsable when the words are not a compute shader or break off; never reads beyond them.
Result<Reflection> reflectSpirv(std::span<const std::uint32_t> words);

}  // namespace macula::gpu
