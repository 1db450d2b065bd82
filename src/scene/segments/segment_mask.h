// Which voxels are left in 3D by what was chosen for segments.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "scene/segments/segmentation_choice.h"
#include "study/segmentation/loaded_segmentation.h"

namespace macula::app {

using LoadedSegmentations = std::vector<std::shared_ptr<const LoadedSegmentation>>;

// Shown is what is in a segment that is alone, where there is one, and in none that is hidden. Segments that
// have no voxel in the volume, or whose segmentation is not among those loaded, count for nothing. Nothing
// where all is shown. The segmentations are of that volume. cancelled, or outOfMemory.
Result<std::optional<Mask>> segmentMask(std::span<const SegmentationChoice> choices,
                                        const LoadedSegmentations& loaded, const Volume& volume,
                                        Progress& progress);

}  // namespace macula::app
