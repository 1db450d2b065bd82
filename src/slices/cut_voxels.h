// Finds the voxels that an ellipse or an outline measures.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "base/volume.h"
#include "slices/measurement.h"

namespace macula::slices {

// Calls visit(voxel) once for each voxel that valuesIn measures, and also for padding, in unspecified order.
// The work is bounded by a few slices of the volume, whatever the radii; an invalid ellipse has no voxels.
void forEachCutVoxel(const Ellipse& ellipse, const Volume& volume,
                     const std::function<void(const glm::ivec3&)>& visit);
// Likewise of the outline in the plane with that normal through the middle of its points.
void forEachCutVoxel(const Outline& outline, const glm::dvec3& normal, const Volume& volume,
                     const std::function<void(const glm::ivec3&)>& visit);

}  // namespace macula::slices
