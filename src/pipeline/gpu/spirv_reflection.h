// What a compute shader says about itself, read from its SPIR-V.
//
// Written by hand, because the SPIRV-Cross of Debian 12 does not accept SPIR-V 1.6. Covers what glslang 12
// makes of our shaders; needs debug names (do not strip).
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
    std::uint32_t offset = 0;  // bytes from the start of the enclosing struct
    std::uint32_t bytes =
        0;  // without trailing padding; 0 for an array whose length is known at run time only
    std::uint32_t arrayStride = 0;  // 0 unless an array
    std::uint32_t arrayLength = 0;  // 0 unless an array of fixed length
    std::uint32_t matrixStride = 0;
    std::vector<ReflectedMember> members;  // of a struct, or of the elements of an array of structs

    const ReflectedMember* find(std::string_view memberName) const;
};

// A binding to a resource, or the push constants (then `type` says nothing).
struct ReflectedBinding {
    std::string name;  // of the block or the variable
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    std::uint32_t count = 1;  // descriptors; 0 when the length is known at run time only
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;
    ReflectedMember block;  // of buffers and push constants: the struct as a whole
};

struct ReflectedSpecialization {
    std::string name;  // empty for an anonymous one: local_size_x_id
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
    std::vector<ReflectedBinding> bindings;  // by set, then binding
    std::vector<ReflectedSpecialization> specializations;
};

// inputNotUsable when the words are no compute shader or break off; never reads beyond them.
Result<Reflection> reflectSpirv(std::span<const std::uint32_t> words);

}  // namespace macula::gpu
