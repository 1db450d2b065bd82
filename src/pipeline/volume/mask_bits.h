// A mask on the grid of a volume: a bit for each voxel, 1 where it is shown.
#pragma once

#include <cstdint>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/clip.h"

namespace macula {

struct MaskBits {
    glm::ivec3 size{0};                // voxels
    std::vector<std::uint32_t> words;  // voxel n is bit n % 32 of word n / 32; x fastest

    bool shows(int i, int j, int k) const {
        const std::size_t n =
            (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x) + std::size_t(i);
        return (words[n / 32] >> (n % 32) & 1u) != 0;
    }
    // Whether the mask shows any voxel of a box, both corners included.
    bool showsAny(const glm::ivec3& low, const glm::ivec3& high) const;
};

// Uses all cores.
MaskBits maskBits(const Mask& mask, const Volume& volume);

}  // namespace macula
