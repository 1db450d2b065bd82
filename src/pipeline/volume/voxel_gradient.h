// How steeply values change at a voxel, as the tracer takes it (gradientOfVoxel in
// shaders/lib/gradient.glsl).
#pragma once

#include <glm/glm.hpp>

#include "base/volume.h"
#include "pipeline/volume/entry_map.h"

namespace macula {

// The length of the gradient, in units of the volume per mm: half the differences between the two neighbours
// along each axis of the grid; beyond the outer voxels the volume goes on, and padding counts as air. The
// volume must be stored16, and `map` its own.
double gradientPerMmAt(const Volume& volume, const EntryMap& map, const glm::ivec3& voxel);

// The part of matter that is steep where the gradient has that length and half of it is steep at `halfPerMm`,
// above 0; 0 to 1. Lengths in the same unit per mm.
double steepPart(double gradientPerMm, double halfPerMm);

}  // namespace macula
