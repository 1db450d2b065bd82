// Finds grids on which all frames of a segmentation lie.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "dicom/segmentation/segmentation.h"
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

using Placements = std::vector<GridPlacement>;  // one for each frame

// Places the frames on this grid without resampling; nothing when one does not lie on it: the first is
// `firstOff`. `slicePositionsMm` as in loadSegmentation.
std::optional<Placements> placeFrames(const Segmentation& segmentation, const glm::dmat4& worldFromVoxel,
                                      std::span<const glm::dvec3> slicePositionsMm = {},
                                      std::size_t* firstOff = nullptr);

struct SegmentationGrid {
    glm::dmat4 worldFromVoxel{1.0};
    glm::ivec3 size{0};
    Placements placements;
};

// The smallest grid that holds all frames; nothing when they lie on no grid, or there are none.
std::optional<SegmentationGrid> ownGrid(const Segmentation& segmentation);

}  // namespace macula::dicom
