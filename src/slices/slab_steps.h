// The depths at which a slab is sampled along the normal of its plane.
#pragma once

#include <vector>

#include "base/volume.h"
#include "slices/slice_plane.h"

namespace macula::slices {

struct SlabStep {
    double depthMm = 0.0;  // from the plane, along its normal
    double weight = 1.0;   // for a mean: in mm, by the trapezoidal rule
};

// Enough for a volume as deep as 8192 of its smallest voxel sides.
inline constexpr int kMostSlabSteps = 16384;

// Sorted by depth: the plane itself, equal steps to both sides of at most half the smallest side of a voxel,
// and both ends of the slab. If the plane is parallel to voxel planes, a whole number of steps leads from one
// voxel plane to the next, so that a plane through voxel centres meets all of them. Steps farther than one
// step outside the volume are left out, so the volume's depth limits the cost; beyond kMostSlabSteps, steps
// are longer. Without a thickness above 0: the plane alone.
std::vector<SlabStep> stepsThrough(const Volume& volume, const SlicePlane& plane, double thicknessMm);

}  // namespace macula::slices
