// Segments that have a colour of their own in 3D.
#pragma once

#include <optional>
#include <span>

#include "app/segmentation/segment_mask.h"
#include "app/state/segmentation_choice.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/additions.h"

namespace macula::app {

// The colours that were chosen for segments in 3D, as in3dOf leaves them out. Where segments lie over one
// another the later one counts. Segments that have no voxel in the volume, or whose segmentation is not among
// those loaded, count for nothing. Nothing where none is coloured. cancelled, or outOfMemory; inputNotUsable
// for more than 255 different colours.
Result<std::optional<SegmentTints>> segmentTints(std::span<const SegmentationChoice> choices,
                                                 const LoadedSegmentations& loaded, const Volume& volume,
                                                 Progress& progress);

}  // namespace macula::app
