#include "app/choice/catalogue.h"

#include <algorithm>
#include <utility>

#include "pipeline/trace/light_rig_json.h"
#include "presets/catalogue.h"
#include "presets/default_preset.h"
#include "presets/embedded_files.h"

namespace macula::app {

namespace {

constexpr std::string_view kLights = "studio";
constexpr std::string_view kLightsOfClear = "even";

template <class Item>
std::shared_ptr<const Item> byName(const std::vector<std::shared_ptr<const Item>>& items,
                                   std::string_view name) {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const auto& item) { return item->name == name; });
    return found == items.end() ? nullptr : *found;
}

template <class Item>
Result<std::shared_ptr<const Item>> findOrExplain(const std::vector<std::shared_ptr<const Item>>& items,
                                                  std::string_view name, const std::string& kind) {
    if (auto found = byName(items, name)) return found;
    std::string names;
    for (const auto& item : items) names += (names.empty() ? "" : ", ") + item->name;
    return Error{ErrorCode::usage,
                 "There is no " + kind + " '" + std::string(name) + "'.",
                 {},
                 "There are: " + names + "."};
}

}  // namespace

Result<Catalogue> builtInCatalogue() {
    Catalogue catalogue;
    MACULA_TRY(const std::vector<TransferFunction> presets, presets::builtInPresets());
    for (const TransferFunction& function : presets) {
        // Offered is what can be drawn as it is meant.
        if (validate(function))
            catalogue.presets.push_back(std::make_shared<const TransferFunction>(function));
    }
    for (const presets::EmbeddedFile& file : presets::lightFiles()) {
        MACULA_TRY(trace::LightRig rig, trace::lightRigFromJson(file.text, std::string(file.name)));
        catalogue.lights.push_back(std::make_shared<const trace::LightRig>(std::move(rig)));
    }
    for (const presets::EmbeddedFile& file : presets::clipFiles()) {
        MACULA_TRY(ClipPreset clip, clipPresetFromJson(file.text, std::string(file.name)));
        catalogue.clips.push_back(std::make_shared<const ClipPreset>(std::move(clip)));
    }
    MACULA_CHECK(!catalogue.presets.empty() && !catalogue.lights.empty());
    return catalogue;
}

Result<std::shared_ptr<const TransferFunction>> findPreset(const Catalogue& catalogue,
                                                           std::string_view name) {
    for (const auto& preset : catalogue.presets) {
        if (presets::isMeant(*preset, name)) return preset;
    }
    return findOrExplain(catalogue.presets, name, "preset");
}

Result<std::shared_ptr<const trace::LightRig>> findLights(const Catalogue& catalogue, std::string_view name) {
    return findOrExplain(catalogue.lights, name, "light rig");
}

std::shared_ptr<const TransferFunction> presetFor(const Catalogue& catalogue, const Volume& volume) {
    auto preset = byName(catalogue.presets, presets::defaultTransfer(volume));
    MACULA_CHECK(preset != nullptr);
    return preset;
}

std::shared_ptr<const trace::LightRig> defaultLights(const Catalogue& catalogue, trace::Look look) {
    const bool clear = look == trace::Look::clear;
    if (auto lights = byName(catalogue.lights, clear ? kLightsOfClear : kLights)) return lights;
    return catalogue.lights.front();
}

}  // namespace macula::app
