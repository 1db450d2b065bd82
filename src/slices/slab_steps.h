// Where a slab is sampled along the normal of its plane.
#pragma once

#include <vector>

#include "base/volume.h"
#include "slices/slice_plane.h"

namespace macula::slices {

struct SlabStep {
    double depthMm = 0.0;  // from the plane, along its normal
    double weight = 1.0;   // in a mean; in mm, of the trapezoidal rule
};

// Enough for a volume that is 8192 of its smallest sides deep.
inline constexpr int kMostSlabSteps = 16384;

// Ascending: the plane itself, equal steps from it to both sides of at most half the smallest side of a
// voxel, and both ends of the slab. Where the plane is parallel to voxel planes a whole number of steps leads
// from one of these to the next, so that a plane through the middles of voxels meets all of them. What lies
// more than a step outside of the volume is left out, so no slab costs more than the volume is deep; where
// that takes more than kMostSlabSteps, steps are longer. A thickness that is not above 0: the plane alone.
std::vector<SlabStep> stepsThrough(const Volume& volume, const SlicePlane& plane, double thicknessMm);

}  // namespace macula::slices
