#include "registration/scalar_grid.h"

#include <algorithm>

#include "base/parallel.h"

namespace macula::registration {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
// Nothing is thinner than vacuum: lower values (-2000, -3024) mark voxels outside the scanner's field of
// view.
constexpr double kNothingHu = -1100.0;
constexpr int kLeastCells = 8;

// How many voxels along each axis make a cell.
glm::ivec3 blockOf(const glm::ivec3& size, const glm::dmat4& worldFromVoxel, double cellMm) {
    glm::ivec3 block(1);
    for (int axis = 0; axis < 3; ++axis) {
        const double sideMm = glm::length(glm::dvec3(worldFromVoxel[axis]));
        const double most = std::max(1, size[axis] / kLeastCells);
        block[axis] = int(std::clamp(std::round(cellMm / sideMm), 1.0, most));
    }
    return block;
}

// A grid without values. Incomplete cells at the far ends are left out.
ScalarGrid emptyGrid(const glm::ivec3& size, const glm::dmat4& worldFromVoxel, const glm::ivec3& block) {
    ScalarGrid grid;
    grid.size = size / block;
    glm::dmat4 voxelFromGrid(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        voxelFromGrid[axis][axis] = block[axis];
        voxelFromGrid[3][axis] = 0.5 * (block[axis] - 1);
    }
    grid.worldFromGrid = worldFromVoxel * voxelFromGrid;
    grid.gridFromWorld = glm::inverse(grid.worldFromGrid);
    grid.values.assign(std::size_t(grid.size.x) * std::size_t(grid.size.y) * std::size_t(grid.size.z), kNone);
    return grid;
}

// valueOf(offset) is the value of a voxel, or NaN.
template <class ValueOf>
void fill(ScalarGrid& grid, const glm::ivec3& size, const glm::ivec3& block, const CancelToken& token,
          const ValueOf& valueOf) {
    const auto width = std::size_t(grid.size.x);
    const int voxels = block.x * block.y * block.z;
    parallelFor(
        std::size_t(grid.size.z),
        [&](std::size_t cellK) {
            std::vector<double> sums(width);
            std::vector<int> counts(width);
            for (int cellJ = 0; cellJ < grid.size.y; ++cellJ) {
                std::fill(sums.begin(), sums.end(), 0.0);
                std::fill(counts.begin(), counts.end(), 0);
                for (int n = 0; n < block.y * block.z; ++n) {
                    const auto j = std::size_t(cellJ) * std::size_t(block.y) + std::size_t(n % block.y);
                    const auto k = cellK * std::size_t(block.z) + std::size_t(n / block.y);
                    std::size_t offset = (k * std::size_t(size.y) + j) * std::size_t(size.x);
                    for (std::size_t cell = 0; cell < width; ++cell) {
                        for (int i = 0; i < block.x; ++i, ++offset) {
                            const float value = valueOf(offset);
                            if (std::isnan(value)) continue;
                            sums[cell] += value;
                            ++counts[cell];
                        }
                    }
                }
                for (std::size_t cell = 0; cell < width; ++cell) {
                    if (2 * counts[cell] >= voxels)
                        grid.values[grid.index(int(cell), cellJ, int(cellK))] =
                            static_cast<float>(sums[cell] / counts[cell]);
                }
            }
        },
        token);
}

}  // namespace

ScalarGrid gridOf(const Volume& volume, double cellMm, const CancelToken& token) {
    const glm::ivec3 size = volume.size();
    const glm::ivec3 block = blockOf(size, volume.worldFromVoxel(), cellMm);
    ScalarGrid grid = emptyGrid(size, volume.worldFromVoxel(), block);
    const float least =
        volume.unit() == Unit::hounsfield ? float(kNothingHu) : std::numeric_limits<float>::lowest();
    if (volume.format() == VoxelFormat::float32) {
        const auto voxels = volume.floatVoxels();
        const float padding = volume.floatPadding().value_or(kNone);
        fill(grid, size, block, token, [&](std::size_t offset) {
            const float value = voxels[offset];
            return value >= least && value != padding ? value : kNone;
        });
        return grid;
    }
    const auto voxels = volume.voxels();
    const StoredRange padding = volume.padding().value_or(StoredRange{1, 0});  // empty when there is none
    const UnitsFromStored units = volume.unitsFromStored();
    fill(grid, size, block, token, [&](std::size_t offset) {
        const std::uint16_t stored = voxels[offset];
        const auto value = static_cast<float>(units(stored));
        return value >= least && !padding.contains(stored) ? value : kNone;
    });
    return grid;
}

ScalarGrid coarser(const ScalarGrid& fine, double cellMm) {
    const glm::ivec3 block = blockOf(fine.size, fine.worldFromGrid, cellMm);
    ScalarGrid grid = emptyGrid(fine.size, fine.worldFromGrid, block);
    fill(grid, fine.size, block, {}, [&](std::size_t offset) { return fine.values[offset]; });
    return grid;
}

}  // namespace macula::registration
