// Compares a struct of shaders/shared as C++ lays it out with what the compiled shader says.
//
//   const auto reflection = gpu::reflectSpirv(shaders::trace_path_comp.words);
//   expectLayoutMatches<TraceParams>(*reflection->pushConstants->block.find("params"),
//                                    {MACULA_FIELD(TraceParams, origin), MACULA_FIELD(TraceParams,
//                                    exposure)});
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "pipeline/gpu/spirv_reflection.h"

#define MACULA_FIELD(Struct, field)                            \
    ::macula::LaidOutField {                                   \
#field, offsetof(Struct, field), sizeof(Struct::field) \
    }

namespace macula {

struct LaidOutField {
    const char* name;
    std::size_t offset;
    std::size_t bytes;
};

// Every field of the shader's struct must be listed, in order.
template <class Struct>
void expectLayoutMatches(const gpu::ReflectedMember& reflected, const std::vector<LaidOutField>& fields) {
    EXPECT_EQ(reflected.members.size(), fields.size()) << reflected.name << ": list every field";
    for (std::size_t i = 0; i < std::min(reflected.members.size(), fields.size()); ++i) {
        const gpu::ReflectedMember& member = reflected.members[i];
        EXPECT_EQ(member.name, fields[i].name) << reflected.name;
        EXPECT_EQ(member.offset, fields[i].offset) << reflected.name << "." << member.name;
        EXPECT_EQ(member.bytes, fields[i].bytes) << reflected.name << "." << member.name;
    }
    // The elements of an array must be as far apart as in C++.
    const std::size_t bytes = reflected.arrayStride > 0 ? reflected.arrayStride : reflected.bytes;
    EXPECT_EQ(bytes, sizeof(Struct)) << reflected.name;
}

}  // namespace macula
