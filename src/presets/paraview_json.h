// Reads colour maps of ParaView, and VolView's medical presets, which have the same format.
#pragma once

#include "presets/imported_preset.h"

namespace macula::presets {

// A list of maps, or one. With AbsoluteRange (VolView) values are those of the volume; without it, the map is
// stretched over the values of each volume, as in ParaView. A map without opacities gets a ramp from 0 to 1,
// and a note. Comments are allowed. Fails with inputNotUsable, also for maps that Macula could not draw
// faithfully: categorical or logarithmic ones, and the colour space CIEDE2000.
Result<ImportedPresets> presetsFromParaviewJson(const PresetText& file);

}  // namespace macula::presets
