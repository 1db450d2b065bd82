// The cropping of a presentation state, as a clip of a volume.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "base/volume.h"
#include "dicom/presentation/volume_presentation.h"
#include "pipeline/volume/clip_json.h"

namespace macula::scene {

// Returns no clip where the cropping keeps all of the volume; drops planes that cut nothing off. Error:
// inputNotUsable, naming `where`, if nothing is left or more than Clip::kMostPlanes planes cut.
Result<std::optional<ClipPreset>> clipOf(const dicom::Cropping& cropping, const Volume& volume,
                                         const std::string& where);

}  // namespace macula::scene
