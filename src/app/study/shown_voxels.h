// Which voxels of a study are shown one by one: the one place where what hides some of them is put together.
#pragma once

#include <optional>
#include <span>

#include "app/clip/cuts.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"

namespace macula::app {

// What `others` shows without what the scissors remove: a voxel goes where its middle is behind an outline.
// Without scissors it is `others` itself, and of no size of its own. Cuts that were made one after the other
// may be asked for together or one by one, with what came of those before as `others`. On all cores.
//
// usage for a cut that is not valid, and where nothing would be left; cancelled; outOfMemory.
Result<std::optional<Mask>> shownVoxels(std::optional<Mask> others, std::span<const ScissorCut> scissors,
                                        const Volume& volume, Progress& progress);

// Whether the mask is of voxels that scissors left.
bool isCutWithScissors(const Mask& mask);

}  // namespace macula::app
