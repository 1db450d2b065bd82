// Which voxels of a volume the scissors leave.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "scene/clip/cuts.h"

namespace macula::app {

inline constexpr std::string_view kCutWithScissors = "cut with scissors";  // Mask::remark

// Without what is behind the outlines: a voxel goes where its middle is. `before` is what this has made of
// cuts that came before these, or nothing: cuts may be asked for together or one after the other. Without
// cuts it is `before` itself. What else is hidden joins in combinedMask. On all cores.
//
// usage for a cut that is not valid, and where nothing would be left; cancelled; outOfMemory.
Result<std::optional<Mask>> scissorMask(std::optional<Mask> before, std::span<const ScissorCut> scissors,
                                        const Volume& volume, Progress& progress);

}  // namespace macula::app
