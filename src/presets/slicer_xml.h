// 3D Slicer's presets.xml, and the volume properties of an MRML scene.
#pragma once

#include "presets/imported_preset.h"

namespace macula::presets {

// Reads every VolumeProperty. The modality comes from its name. Leaves out an effective range that it cannot
// read, and notes it: in that of CT-X-ray a number has two points. Fails with inputNotUsable.
Result<ImportedPresets> presetsFromSlicerXml(const PresetText& file);

}  // namespace macula::presets
