// 3D Slicer's presets.xml, and the volume properties of an MRML scene.
#pragma once

#include "presets/imported_preset.h"

namespace macula::presets {

// Every VolumeProperty. The modality comes from its name. An effective range that cannot be read is left out,
// and said: the one of CT-X-ray has two points in a number. Fails with inputNotUsable.
Result<ImportedPresets> presetsFromSlicerXml(const PresetText& file);

}  // namespace macula::presets
