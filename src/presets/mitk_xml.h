// Reads MITK's transfer functions.
#pragma once

#include "presets/imported_preset.h"

namespace macula::presets {

// <Version TransferfunctionVersion="1"/> and <TransferFunction> with ScalarOpacity, GradientOpacity and
// Color. Points may come in any order; of several at one value the last counts, as in VTK. Assumes Hounsfield
// units if the file names no unit, with a note. Fails with inputNotUsable.
Result<ImportedPresets> presetsFromMitkXml(const PresetText& file);

}  // namespace macula::presets
