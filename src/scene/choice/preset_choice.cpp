#include "scene/choice/preset_choice.h"

#include <algorithm>
#include <filesystem>

#include "presets/catalogue.h"
#include "presets/preset_file.h"
#include "scene/choice/nearest_name.h"
#include "scene/transfer/same_transfer.h"

namespace macula::scene {

namespace {

std::vector<std::string> builtInNames() {
    std::vector<std::string> names;
    if (const auto all = presets::builtInPresets()) {
        for (const TransferFunction& preset : *all) names.push_back(preset.name);
    }
    return names;
}

std::optional<TransferFunction> builtIn(const std::string& typed) {
    Result<std::vector<TransferFunction>> all = presets::builtInPresets();
    if (!all) return std::nullopt;
    const auto found = std::find_if(all->begin(), all->end(), [&](const TransferFunction& preset) {
        return presets::isMeant(preset, typed);
    });
    if (found == all->end()) return std::nullopt;
    return std::move(*found);
}

}  // namespace

Result<presets::ImportedPreset> choosePreset(const std::string& typed) {
    if (std::optional<TransferFunction> preset = builtIn(typed))
        return presets::ImportedPreset{std::move(*preset), {}};
    const std::filesystem::path path = typed.substr(0, typed.find('#'));
    std::error_code error;
    if (!path.has_extension() && !std::filesystem::exists(typed, error) &&
        !std::filesystem::exists(path, error)) {
        return noSuchName(Text("There is no such preset."), typed, builtInNames(),
                          Text("Or give a number from macula presets, or the path of a preset file."));
    }
    return presets::readPresetFrom(typed);
}

std::string publicPresetName(const std::string& typed) {
    const std::optional<TransferFunction> preset = builtIn(typed);
    return preset ? preset->name : "custom";
}

std::string publicPresetName(const TransferFunction& preset) {
    const Result<std::vector<TransferFunction>> all = presets::builtInPresets();
    if (!all) return "custom";
    const auto found = std::find_if(all->begin(), all->end(), [&](TransferFunction known) {
        known.fitToVolume = preset.fitToVolume;
        return isSame(known, preset);
    });
    return found == all->end() ? "custom" : found->name;
}

}  // namespace macula::scene
