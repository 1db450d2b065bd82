// Readers of the presets of other programs, a source for each format or program. All fail with
// inputNotUsable.
#pragma once

#include <functional>
#include <string>

#include "presets/imported_preset.h"

namespace macula::presets {

// The text of the property list of a colour table by its name, or an error that says it is missing.
using FindColourTable = std::function<Result<std::string>(const std::string& name)>;

// 3D presets of Horos and OsiriX, which InVesalius has too. A preset with a 16-bit CLUT: opacity is the
// square of its curves, which all become one. A simple preset: a table of 256 colours over the window, from
// `findTable`, and a named opacity table. Values are Hounsfield units; opacities apply to 1 mm.
Result<ImportedPresets> presetsFromHorosPlist(const PresetText& file, const FindColourTable& findTable);

// MITK's transfer functions: <Version TransferfunctionVersion="1"/> and <TransferFunction> with
// ScalarOpacity, GradientOpacity and Color. Points may come in any order; of several at one value the last
// counts, as in VTK. Assumes Hounsfield units if the file names no unit, with a note.
Result<ImportedPresets> presetsFromMitkXml(const PresetText& file);

// Colour maps of ParaView, and VolView's medical presets, which have the same format: a list of maps, or one.
// With AbsoluteRange (VolView) values are those of the volume; without it, the map is stretched over the
// values of each volume, as in ParaView. A map without opacities gets a ramp from 0 to 1, and a note.
// Comments are allowed. Fails also for maps that Macula could not draw faithfully: categorical or logarithmic
// ones, and the colour space CIEDE2000.
Result<ImportedPresets> presetsFromParaviewJson(const PresetText& file);

// 3D Slicer's .vp, nine lines of text: interpolation, shade, diffuse, ambient, specular, specular power,
// scalar opacity, gradient opacity, colour. The file has no name in it; the modality comes from the file's
// own name. The message names the line.
Result<ImportedPresets> presetsFromSlicerVp(const PresetText& file);

// 3D Slicer's presets.xml, and the volume properties of an MRML scene: every VolumeProperty. The modality
// comes from its name. Leaves out an effective range that it cannot read, and notes it: CT-X-ray's has a
// number with two decimal points.
Result<ImportedPresets> presetsFromSlicerXml(const PresetText& file);

}  // namespace macula::presets
