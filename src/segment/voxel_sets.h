// Sets of voxels joined, subtracted and intersected, and the memory that work on them takes.
#pragma once

#include <cstddef>

#include "base/result.h"
#include "base/volume.h"
#include "base/voxel_set.h"

namespace macula::segment {

// The results are cropped. May throw std::bad_alloc.
VoxelSet united(const VoxelSet& a, const VoxelSet& b);
VoxelSet without(const VoxelSet& a, const VoxelSet& b);
VoxelSet intersected(const VoxelSet& a, const VoxelSet& b);

// Every voxel of the box that is not in the set; both corners are included.
VoxelSet complement(const VoxelSet& set, const glm::ivec3& low, const glm::ivec3& high);

// Of one voxel of the volume, in ml; of a sheared one, too.
double voxelMl(const glm::dmat4& worldFromVoxel);

// Fails with outOfMemory where so many bytes are not there, before anybody asks for them.
Result<void> checkMemory(double voxels, double bytesPerVoxel);

Error segmentingCancelled();

}  // namespace macula::segment
