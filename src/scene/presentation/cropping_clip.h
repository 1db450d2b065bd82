// The cropping of a presentation state, as a clip of a volume.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/presentation/volume_presentation.h"
#include "pipeline/volume/clip_json.h"

namespace macula::app {

// Nothing where all of the volume is left. What cuts nothing off is no part of it. inputNotUsable when
// nothing is left, or more than Clip::kMostPlanes planes cut; `where` is for the error.
Result<std::optional<ClipPreset>> clipOf(const dicom::Cropping& cropping, const Volume& volume,
                                         const std::string& where);

}  // namespace macula::app
