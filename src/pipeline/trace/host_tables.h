// What the tracing functions of shaders/lib read where they run on the host (shader_host.inl).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "pipeline/trace/environment.h"
#include "pipeline/volume/voxel_blocks.h"
#include "shared/trace_params.h"

namespace macula::trace {

// The voxels of a volume as table entries, all of them, x fastest.
struct LinearVoxels {
    const std::uint16_t* entries = nullptr;
    glm::ivec3 size{0};

    bool isEmpty() const { return entries == nullptr; }
    std::uint32_t at(const glm::ivec3& voxel) const {
        return entries[(std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y)) *
                           std::size_t(size.x) +
                       std::size_t(voxel.x)];
    }

    struct Blocks {};
    Blocks blocksOfBrick(const glm::ivec3&) const { return {}; }
    std::uint32_t from(Blocks, const glm::ivec3& voxel) const { return at(voxel); }
};

// The same as they lie on a device: the pool and the table of DeviceVolume.
struct PooledVoxels {
    const std::uint16_t* pool = nullptr;
    const std::uint32_t* words = nullptr;  // four for each brick, the last of them that of its own block
    glm::ivec3 grid{0};                    // bricks
    int lastLayer = 0;                     // of blocks along z

    bool isEmpty() const { return words == nullptr; }
    std::uint32_t at(const glm::ivec3& voxel) const {
        const glm::ivec3 block = voxel >> 3;
        return valueIn(wordsOf(block, block.z)[3], voxel & 7);
    }

    // The words of the blocks in which a brick lies, at the low end of z and at the high end.
    struct Blocks {
        const std::uint32_t* near;
        const std::uint32_t* far;
        glm::ivec3 high;  // the first voxel of the high blocks
    };
    Blocks blocksOfBrick(const glm::ivec3& brick) const {
        return {wordsOf(brick, std::max(brick.z - 1, 0)), wordsOf(brick, std::min(brick.z, lastLayer)),
                brick << 3};
    }
    std::uint32_t from(const Blocks& blocks, const glm::ivec3& voxel) const {
        const std::uint32_t* const layer = voxel.z >= blocks.high.z ? blocks.far : blocks.near;
        return valueIn(layer[(voxel.y >= blocks.high.y ? 2 : 0) + (voxel.x >= blocks.high.x ? 1 : 0)],
                       voxel & 7);
    }

    const std::uint32_t* wordsOf(const glm::ivec3& brick, int layer) const {
        return words +
               4 * ((std::size_t(layer) * std::size_t(grid.y) + std::size_t(brick.y)) * std::size_t(grid.x) +
                    std::size_t(brick.x));
    }
    // placeIn() and valueOf() of shaders/trace/host.glsl.
    std::uint32_t valueIn(std::uint32_t word, const glm::ivec3& within) const {
        const std::uint32_t level = word >> 30;
        const std::uint32_t unitOrValue = word & 0x3fffffffu;
        if (level == kSingle) return unitOrValue;
        const glm::ivec3 cell = within >> int(level);
        const int edgeBits = 3 - int(level);
        return pool[(std::size_t(unitOrValue) << 3) +
                    std::size_t((((cell.z << edgeBits) | cell.y) << edgeBits) | cell.x)];
    }
};

// What castSample() of shaders/lib/cast.glsl does.
struct CastKind {
    int look = shared::kCastMatter;  // of trace_params.h
    bool shading = false;
};

// What is empty, the scene does not have.
template <class Voxels>
struct HostTables {
    Voxels voxels;
    const float* extinctionPerMm = nullptr;  // by entry
    std::span<const float> gradientOpacity = {};
    const glm::vec4* albedo = nullptr;      // by entry
    std::span<const glm::vec4> steep = {};  // albedo and extinction of steep matter, by entry
    bool hasSteepDensity = false;           // and its extinction differs somewhere
    const float* bounds = nullptr;          // by brick
    const EnvironmentTexel* environment = nullptr;
    const float* cumulative = nullptr;         // see shaders/lib/environment.glsl
    std::span<const std::uint32_t> mask = {};  // a bit for each voxel
    Voxels second = {};                        // of the second volume
    const glm::vec4* additions = nullptr;      // additionTable
    std::span<const std::uint8_t> tints = {};  // the segment of each voxel, in their box
    std::span<const std::uint32_t> indirectTags = {};
    std::span<const glm::uvec4> indirectCells = {};
};

}  // namespace macula::trace
