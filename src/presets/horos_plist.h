// Reads 3D presets of Horos and OsiriX, which InVesalius has too.
#pragma once

#include <functional>

#include "presets/imported_preset.h"

namespace macula::presets {

// The text of the property list of a colour table by its name, or an error that says it is missing.
using FindColourTable = std::function<Result<std::string>(const std::string& name)>;

// A preset with a 16-bit CLUT: opacity is the square of its curves, which all become one. A simple preset: a
// table of 256 colours over the window, from `findTable`, and a named opacity table. Values are Hounsfield
// units; opacities apply to 1 mm. Fails with inputNotUsable.
Result<ImportedPresets> presetsFromHorosPlist(const PresetText& file, const FindColourTable& findTable);

}  // namespace macula::presets
