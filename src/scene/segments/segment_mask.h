// The mask of voxels that the choices for segments leave visible in 3D.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "scene/segments/segmentation_settings.h"
#include "study/segmentation/loaded_segmentation.h"

namespace macula::scene {

using LoadedSegmentations = std::vector<std::shared_ptr<const study::LoadedSegmentation>>;

// Shows the voxels of segments that are `alone` (all voxels if there is none), except those of `hidden`
// segments. Ignores segments without a voxel in the volume, or not in `loaded`. No mask if all is shown.
// `loaded` is on the grid of `volume`. Errors: cancelled, outOfMemory.
Result<std::optional<Mask>> segmentMask(std::span<const SegmentationSettings> choices,
                                        const LoadedSegmentations& loaded, const Volume& volume,
                                        Progress& progress);

}  // namespace macula::scene
