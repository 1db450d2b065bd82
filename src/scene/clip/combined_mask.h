// All that hides single voxels of a volume, as one mask: the table, scissors, segments.
#pragma once

#include <optional>
#include <span>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"

namespace macula::app {

// Shows what every one of them shows; nothing of none. One by itself is that one, and costs nothing; several
// become a bit for each voxel of the volume, and remarks are joined in their order. On all cores, for whoever
// is not on a thread that draws. cancelled, or outOfMemory.
Result<std::optional<Mask>> combinedMask(std::span<const Mask> masks, const Volume& volume,
                                         Progress& progress);

}  // namespace macula::app
