// Maps the pixels of one image to the voxels of a grid on which they lie exactly.
#pragma once

#include <optional>

#include "dicom/stack/geometry.h"

namespace macula::dicom {

// Pixel (column, row) is voxel origin + column * columnStep + row * rowStep, which may lie outside of the
// grid. The steps are along two axes of the grid, in either direction.
struct GridPlacement {
    glm::ivec3 origin{0};
    glm::ivec3 columnStep{0};
    glm::ivec3 rowStep{0};

    bool operator==(const GridPlacement&) const = default;
};

// Places the image; nothing when a pixel is more than a hundredth of a voxel from its voxel's centre. The
// transform is affine; the plane is usable.
std::optional<GridPlacement> placeOnGrid(const glm::dmat4& voxelFromWorld, const ImagePlane& plane,
                                         int columns, int rows);

}  // namespace macula::dicom
