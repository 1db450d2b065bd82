// A coarse copy of a volume for separating patient and table: how much of each block of voxels is solid.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/volume.h"

namespace macula::segment {

// One byte per block, 0 or not; in the order of the grid.
using Mask = std::vector<std::uint8_t>;

// Blocks of voxels of about 2 mm. The axes are those of the volume in another order: `c` runs along the
// patient, as the table does, `a` and `b` across; a is fastest. In a sheared volume c is the stack direction,
// along which the couch moved.
struct Grid {
    glm::ivec3 size{0};
    glm::dvec3 spacingMm{1.0};

    std::size_t count() const { return sliceSize() * std::size_t(size.z); }
    std::size_t sliceSize() const { return std::size_t(size.x) * std::size_t(size.y); }
    std::size_t index(int a, int b, int c) const {
        return (std::size_t(c) * std::size_t(size.y) + std::size_t(b)) * std::size_t(size.x) + std::size_t(a);
    }
};

struct CoarseGrid {
    Grid grid;
    double voxelsPerBlock = 1.0;
    double blockMl = 0.0;
    std::array<int, 3> factor{1, 1, 1};          // voxels per block along i, j, k
    std::array<std::size_t, 3> stride{1, 1, 1};  // step of the grid's index per block along i, j, k
    std::vector<std::uint8_t> solid;  // 0 to 255: share of voxels above kSolidHu, denser than any foam
    std::vector<std::uint8_t> faint;  // the same above kFaintHu: mattress covers are thinner than a voxel
    Mask outside;                     // most of the block is padding: the scanner saw nothing there
};

// Above this a voxel is solid, in HU: fat is (-120), foam and lung are not.
inline constexpr double kSolidHu = -200.0;
inline constexpr double kFaintHu = -500.0;

// The coarse grid of a volume in HU. Incomplete when cancelled. May throw std::bad_alloc.
CoarseGrid makeCoarseGrid(const Volume& volume, const CancelToken& token);

}  // namespace macula::segment
