// One mask from all that hides single voxels of a volume: the table, scissors, segments.
#pragma once

#include <optional>
#include <span>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"

namespace macula::scene {

// Shows the voxels that all masks show; nothing without masks. A single mask is returned as it is, at no
// cost; several become one bit per voxel of the volume, with the remarks joined in order. Runs on all cores;
// do not call it on a thread that draws. Errors: cancelled, outOfMemory.
Result<std::optional<Mask>> combinedMask(std::span<const Mask> masks, const Volume& volume,
                                         Progress& progress);

}  // namespace macula::scene
