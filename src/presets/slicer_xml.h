// Reads 3D Slicer's presets.xml, and the volume properties of an MRML scene.
#pragma once

#include "presets/imported_preset.h"

namespace macula::presets {

// Reads every VolumeProperty. The modality comes from its name. Leaves out an effective range that it cannot
// read, and notes it: CT-X-ray's has a number with two decimal points. Fails with inputNotUsable.
Result<ImportedPresets> presetsFromSlicerXml(const PresetText& file);

}  // namespace macula::presets
