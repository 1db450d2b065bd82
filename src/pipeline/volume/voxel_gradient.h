// How steeply values change at a voxel, as the tracer computes it (gradientOfVoxel in
// shaders/lib/gradient.glsl).
#pragma once

#include <glm/glm.hpp>

#include "base/volume.h"
#include "pipeline/volume/entry_map.h"

namespace macula {

// The length of the gradient, in units of the volume per mm, by central differences along the axes of the
// grid. Outer voxels are repeated beyond the border, and padding counts as air. The volume must be stored16,
// and `map` its own.
double gradientPerMmAt(const Volume& volume, const EntryMap& map, const glm::ivec3& voxel);

// The part of matter, 0 to 1, that is steep at this length of the gradient, if half of it is at `halfPerMm`,
// above 0. Both lengths have the same unit per mm.
double steepPart(double gradientPerMm, double halfPerMm);

}  // namespace macula
