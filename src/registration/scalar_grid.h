// A volume with fewer, larger voxels, for registration.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/progress.h"
#include "base/volume.h"

namespace macula::registration {

// Its axes are those of the voxels, oblique and sheared as they are. Positions use the whole affine map, so a
// tilted gantry needs no other grid.
struct ScalarGrid {
    glm::ivec3 size{0};
    glm::dmat4 worldFromGrid{1.0};
    glm::dmat4 gridFromWorld{1.0};
    std::vector<float> values;  // i fastest; NaN: no value

    std::size_t index(int i, int j, int k) const {
        return (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x) + std::size_t(i);
    }
    // Trilinear between eight cells. NaN outside the outer centres, and where one of the eight has no value.
    float at(const glm::dvec3& cell) const;
};

// Cells of about `cellMm` with the mean of the voxels in each; NaN if fewer than half of them have a value.
// Padding has none, nor has a voxel below -1100 HU. At least eight cells along each axis, if it has as many
// voxels. Incomplete when cancelled. May throw std::bad_alloc.
ScalarGrid gridOf(const Volume& volume, double cellMm, const CancelToken& token);

// The same, from a finer grid.
ScalarGrid coarser(const ScalarGrid& fine, double cellMm);

inline float ScalarGrid::at(const glm::dvec3& cell) const {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    // Written so that NaN counts as outside.
    if (!(cell.x >= 0.0 && cell.y >= 0.0 && cell.z >= 0.0 && cell.x < size.x - 1 && cell.y < size.y - 1 &&
          cell.z < size.z - 1))
        return kNone;
    const glm::ivec3 low(cell);
    const glm::vec3 share(cell - glm::dvec3(low));
    const float* v = values.data() + index(low.x, low.y, low.z);
    const std::size_t row = std::size_t(size.x);
    const std::size_t slice = row * std::size_t(size.y);
    const auto along = [&](const float* at) { return at[0] + (at[1] - at[0]) * share.x; };
    const float front = along(v) + (along(v + row) - along(v)) * share.y;
    const float back = along(v + slice) + (along(v + slice + row) - along(v + slice)) * share.y;
    return front + (back - front) * share.z;  // NaN propagates
}

}  // namespace macula::registration
