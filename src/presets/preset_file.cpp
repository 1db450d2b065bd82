#include "presets/preset_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "base/parsing.h"
#include "pipeline/volume/json_reader.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/preset_name.h"
#include "presets/vtk_curve.h"

namespace macula::presets {

namespace fs = std::filesystem;

namespace {

enum class Format { volumePropertyJson, paraviewJson, horosPlist, mitkXml, slicerXml, slicerVp, unknown };

// The text without leading blanks or byte order mark, and without the zeros of UTF-16: enough to recognise
// formats.
std::string lettersOf(std::string_view text) {
    std::string letters;
    std::copy_if(text.begin(), text.end(), std::back_inserter(letters), [](char c) { return c != '\0'; });
    const std::size_t first = letters.find_first_not_of(" \t\r\n\xEF\xBB\xBF\xFE\xFF");
    return first == std::string::npos ? std::string() : letters.substr(first);
}

Format formatOf(const PresetText& file) {
    const std::string letters = lettersOf(file.text);
    const auto holds = [&](std::string_view word) { return letters.find(word) != std::string::npos; };
    if (letters.starts_with("bplist")) return Format::horosPlist;
    if (letters.starts_with('<')) {
        if (holds("<plist")) return Format::horosPlist;
        return holds("<TransferFunction") ? Format::mitkXml : Format::slicerXml;
    }
    const bool json = letters.starts_with('{') || letters.starts_with('[') || letters.starts_with('/') ||
                      file.where.ends_with(".json");
    if (json) {
        const bool map = letters.starts_with('[') || holds("\"RGBPoints\"") || holds("\"IndexedColors\"");
        return map && !holds("\"volumeProperties\"") ? Format::paraviewJson : Format::volumePropertyJson;
    }
    if (letters.empty()) return Format::unknown;
    const bool number = letters.find_first_of("0123456789") == 0 || file.where.ends_with(".vp");
    return number ? Format::slicerVp : Format::unknown;
}

Result<ImportedPresets> fromVolumePropertyJson(const PresetText& file) {
    ImportedPreset preset;
    MACULA_TRY(preset.function, transferFunctionFromJson(file.text, file.where, keyFrom(file.fallbackName)));
    const JsonDocument document(file.text, file.where);
    const JsonNode root = document.root();
    if (!root.find("macula")) {
        if (!nameAfter(preset.function, file.fallbackName)) preset.notes.push_back(assumedHounsfield());
        preset.function.source = "3D Slicer";
    }
    const std::vector<JsonNode> properties = root["volumeProperties"].items(1, 64);
    if (properties.size() > 1 || properties.front()["components"].items(1, 64).size() > 1)
        preset.notes.emplace_back(Text("Only the first volume property, and its first component, are used."));
    return ImportedPresets{std::move(preset)};
}

// Refuses names that lead to another folder.
Result<std::string> findTableBeside(const fs::path& path, const std::string& name) {
    if (!name.empty() && name.find_first_of("/\\") == std::string::npos && name.front() != '.') {
        const fs::path folder = path.parent_path();
        for (const fs::path& place : {folder, folder / "CLUTs", folder / "color_list",
                                      folder / ".." / "CLUTs", folder / ".." / "color_list"}) {
            const fs::path table = place / (name + ".plist");
            std::error_code error;
            if (fs::is_regular_file(table, error)) return readText(table);
        }
    }
    return Error{
        ErrorCode::inputNotUsable, Text("The preset names the colour table '{}', which is not there.", name),
        path.string(),
        Text("Put the table beside the preset as NAME.plist, or save a 16-bit CLUT with the preset.")};
}

// The name of a file without its extensions: "CT-Bone" for CT-Bone.vp.json.
std::string nameOf(const fs::path& path) {
    fs::path name = path.stem();
    if (name.extension() == ".vp") name = name.stem();
    return name.string();
}

}  // namespace

Result<ImportedPresets> readPresets(const PresetText& file, const FindColourTable& findTable) {
    switch (formatOf(file)) {
        case Format::volumePropertyJson:
            return fromVolumePropertyJson(file);
        case Format::paraviewJson:
            return presetsFromParaviewJson(file);
        case Format::horosPlist:
            return presetsFromHorosPlist(file, findTable);
        case Format::mitkXml:
            return presetsFromMitkXml(file);
        case Format::slicerXml:
            return presetsFromSlicerXml(file);
        case Format::slicerVp:
            return presetsFromSlicerVp(file);
        case Format::unknown:
            break;
    }
    return Error{
        ErrorCode::inputNotUsable,
        lettersOf(file.text).empty() ? Text("The preset file is empty.")
                                     : Text("The file is no preset of a known format."),
        file.where,
        Text("Give a JSON preset, a .vp or presets.xml of 3D Slicer, a ParaView or VolView JSON, an XML of "
             "MITK, or a plist of Horos.")};
}

Result<ImportedPresets> readPresetFile(const fs::path& path) {
    MACULA_TRY(const std::string text, readText(path));
    return readPresets({text, path.string(), nameOf(path)},
                       [&](const std::string& name) { return findTableBeside(path, name); });
}

Result<ImportedPreset> readPresetFrom(const std::string& fileAndName) {
    std::error_code error;
    std::string path = fileAndName;
    std::string wanted;
    if (const std::size_t hash = path.rfind('#'); hash != std::string::npos && !fs::exists(path, error)) {
        wanted = path.substr(hash + 1);
        path.resize(hash);
    }
    MACULA_TRY(ImportedPresets presets, readPresetFile(path));
    if (wanted.empty() && presets.size() == 1) return std::move(presets.front());
    std::string names;
    for (std::size_t i = 0; i < presets.size(); ++i) {
        const std::string& title = presets[i].function.title;
        if (lowerCase(title) == lowerCase(wanted) || presets[i].function.name == wanted ||
            fmt::to_string(i + 1) == wanted) {
            return std::move(presets[i]);
        }
        names += (names.empty() ? "" : ", ") + title;
    }
    if (wanted.empty()) {
        return Error{ErrorCode::usage, Text("The file holds {} presets.", presets.size()), path,
                     Text("Add # and a name or its place, as in FILE#{}. There are: {}.",
                          presets.front().function.title, names)};
    }
    return Error{ErrorCode::usage, Text("The file holds no preset '{}'.", wanted), path,
                 Text("There are: {}.", names)};
}

}  // namespace macula::presets
