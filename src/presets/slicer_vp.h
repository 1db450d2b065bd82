// Reads 3D Slicer's .vp: nine lines of text.
#pragma once

#include "presets/imported_preset.h"

namespace macula::presets {

// interpolation, shade, diffuse, ambient, specular, specular power, scalar opacity, gradient opacity, colour.
// The file has no name in it; the modality comes from the file's own name. Fails with inputNotUsable; the
// message names the line.
Result<ImportedPresets> presetsFromSlicerVp(const PresetText& file);

}  // namespace macula::presets
