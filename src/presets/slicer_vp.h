// 3D Slicer's .vp: nine lines of text.
#pragma once

#include "presets/imported_preset.h"

namespace macula::presets {

// interpolation, shade, diffuse, ambient, specular, specular power, scalar opacity, gradient opacity, colour.
// The file names nothing; its own name says the modality. Fails with inputNotUsable; the message tells the
// line.
Result<ImportedPresets> presetsFromSlicerVp(const PresetText& file);

}  // namespace macula::presets
