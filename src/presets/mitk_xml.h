// MITK's transfer functions.
#pragma once

#include "presets/imported_preset.h"

namespace macula::presets {

// <Version TransferfunctionVersion="1"/> and <TransferFunction> with ScalarOpacity, GradientOpacity and
// Color. Points may come in any order; of several at one value the last counts, as in VTK. What is not said
// is taken for Hounsfield units, with a note. Fails with inputNotUsable.
Result<ImportedPresets> presetsFromMitkXml(const PresetText& file);

}  // namespace macula::presets
