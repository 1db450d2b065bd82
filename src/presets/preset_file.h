// Reads a file of presets in any known format, which its content determines.
#pragma once

#include <filesystem>

#include "presets/imported_preset.h"
#include "presets/importers.h"

namespace macula::presets {

// Ours and 3D Slicer's .vp.json, Slicer's presets.xml and .vp, ParaView and VolView JSON, MITK XML, Horos and
// OsiriX plist. Fails with inputNotUsable, and a hint at what would help.
Result<ImportedPresets> readPresets(const PresetText& file, const FindColourTable& findTable);

// The same from disk. Looks for colour tables of Horos beside the file, and in a folder CLUTs or color_list
// there or beside its folder.
Result<ImportedPresets> readPresetFile(const std::filesystem::path& path);

// One preset: "FILE", if it holds only one, or "FILE#NAME" or "FILE#3"; the name in any case, the number
// counted from 1 in the file.
Result<ImportedPreset> readPresetFrom(const std::string& fileAndName);

}  // namespace macula::presets
