#include "pipeline/volume/clip_bricks.h"

#include "base/check.h"
#include "base/parallel.h"

namespace macula {

namespace {

// The box of a brick, a voxel larger on all sides: rounding in a shader may reach slightly beyond a brick.
Box roomOf(const glm::ivec3& brick) {
    const glm::dvec3 low = double(kBrickVoxels) * glm::dvec3(brick) - 2.0;
    return {low, low + double(kBrickVoxels) + 2.0};
}

// Calls body(index, room) for every brick, with layers on all cores.
template <class Body>
void forEachRoom(const BrickGrid& grid, const Body& body) {
    parallelFor(std::size_t(grid.size.z), [&](std::size_t layer) {
        const int z = static_cast<int>(layer);
        for (int y = 0; y < grid.size.y; ++y) {
            for (int x = 0; x < grid.size.x; ++x) body(grid.index(x, y, z), roomOf({x, y, z}));
        }
    });
}

}  // namespace

void emptyRemovedBricks(const Clip& clip, const Volume& volume, const BrickGrid& grid,
                        std::span<float> bounds) {
    MACULA_CHECK_EQ(bounds.size(), grid.ranges.size());
    if (clip.isNothing() || clip.removedCastsShadow) return;
    forEachRoom(grid, [&](std::size_t brick, const Box& room) {
        if (bounds[brick] > 0.0f && removesAll(clip, volume.worldFromVoxel(), room)) bounds[brick] = 0.0f;
    });
}

void emptyMaskedBricks(const MaskBits& mask, const BrickGrid& grid, std::span<float> bounds) {
    MACULA_CHECK_EQ(bounds.size(), grid.ranges.size());
    parallelFor(std::size_t(grid.size.z), [&](std::size_t layer) {
        for (int y = 0; y < grid.size.y; ++y) {
            for (int x = 0; x < grid.size.x; ++x) {
                float& bound = bounds[grid.index(x, y, static_cast<int>(layer))];
                if (!(bound > 0.0f)) continue;
                const glm::ivec3 brick(x, y, static_cast<int>(layer));
                const glm::ivec3 low = glm::max(brick * kBrickVoxels - 1, glm::ivec3(0));
                const glm::ivec3 high = glm::min(brick * kBrickVoxels + kBrickVoxels - 1, mask.size - 1);
                if (!mask.showsAny(low, high)) bound = 0.0f;
            }
        }
    });
}

std::vector<std::uint8_t> bricksAtGreyFaces(const Clip& clip, const Volume& volume, const BrickGrid& grid) {
    if (clip.isNothing() || !clip.greyFaces) return {};
    std::vector<std::uint8_t> faces(grid.ranges.size());
    forEachRoom(grid, [&](std::size_t brick, const Box& room) {
        const glm::dmat4& worldFromVoxel = volume.worldFromVoxel();
        faces[brick] = !removesAll(clip, worldFromVoxel, room) && !removesNothing(clip, worldFromVoxel, room);
    });
    return faces;
}

}  // namespace macula
