// The voxels under a round brush.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "base/volume.h"
#include "base/voxel_set.h"

namespace macula::segment {

inline constexpr double kLargestBrushMm = 100.0;  // radius

struct Stroke {
    glm::dvec3 fromMm{0.0};  // patient LPS
    glm::dvec3 toMm{0.0};
    double radiusMm = 1.0;  // clamped to 0 to kLargestBrushMm
    // Of a slice with this unit normal through `fromMm`: only voxels whose centre is at most half a voxel,
    // measured along it, away. Nothing: a ball.
    std::optional<glm::dvec3> sliceNormal = {};
};

// The voxels of the grid whose centre is within the radius of the way between both points, and those nearest
// to its ends; cropped. Empty beside the grid, and for numbers that are not finite. May throw std::bad_alloc.
VoxelSet voxelsUnder(const Stroke& stroke, const glm::dmat4& worldFromVoxel, const glm::ivec3& size);

}  // namespace macula::segment
