// The mask of the voxels that the scissors leave.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "scene/clip/cuts.h"

namespace macula::scene {

// Hides the voxels whose centres the cuts remove. `before` is the result of this function for earlier cuts,
// or nothing: cuts can be applied together or one after the other. Without cuts the result is `before`.
// combinedMask adds what else is hidden. Runs on all cores.
//
// Errors: usage for an invalid cut and when nothing would be left; cancelled; outOfMemory.
Result<std::optional<Mask>> scissorMask(std::optional<Mask> before, std::span<const ScissorCut> scissors,
                                        const Volume& volume, Progress& progress);

}  // namespace macula::scene
