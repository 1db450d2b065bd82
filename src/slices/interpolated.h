// Finds where pictures and measurements meet interpolated slices, for which no image was taken
// (Provenance::interpolatedSlices).
#pragma once

#include <vector>

#include "base/volume.h"
#include "slices/measurement.h"
#include "slices/sampled_slice.h"
#include "slices/slice_plane.h"

namespace macula::slices {

bool isInterpolated(const Volume& volume, int slice);

// The volume's ranges of interpolated slices that the picture of the frame, or its slab, meets. A slice is as
// thick as the distance to the next.
std::vector<SliceRange> interpolatedIn(const Volume& volume, const SliceFrame& frame, const Slab& slab);

// In pixels of the picture.
struct PictureLine {
    glm::dvec2 from{0.0};
    glm::dvec2 to{0.0};
};
// The lines in the picture at which the range begins and ends within the volume: at most two, and none in a
// plane that is parallel to the slices.
std::vector<PictureLine> edgesOf(const SliceRange& slices, const Volume& volume, const SliceFrame& frame);

// The share of a measurement that lies in such slices, 0 to 1: of the voxels that valuesIn measures in an
// ellipse or an outline, else of the points.
double interpolatedShare(const Measurement& measurement, const Volume& volume);

}  // namespace macula::slices
