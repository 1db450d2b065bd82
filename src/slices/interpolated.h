// Slices in which no image was taken (Provenance::interpolatedSlices), where pictures and measurements meet
// them.
#pragma once

#include <vector>

#include "base/volume.h"
#include "slices/measurement.h"
#include "slices/sampled_slice.h"
#include "slices/slice_plane.h"

namespace macula::slices {

bool isInterpolated(const Volume& volume, int slice);

// Of the volume's ranges of such slices, those that the picture of the frame meets, or its slab reaches. A
// slice is as thick as the distance to the next.
std::vector<SliceRange> interpolatedIn(const Volume& volume, const SliceFrame& frame, const Slab& slab);

// In pixels of the picture.
struct PictureLine {
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
};
// Where the range begins and ends in the picture, within the volume: at most two lines. None in a plane that
// is parallel to the slices.
std::vector<PictureLine> edgesOf(const SliceRange& slices, const Volume& volume, const SliceFrame& frame);

// How much of what is measured lies in such slices, 0 to 1: of the voxels that the values of an ellipse are
// over, else of the points.
double interpolatedShare(const Measurement& measurement, const Volume& volume);

}  // namespace macula::slices
