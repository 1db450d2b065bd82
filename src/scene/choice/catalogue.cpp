#include "scene/choice/catalogue.h"

#include <algorithm>
#include <utility>

#include "presets/catalogue.h"
#include "presets/default_preset.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/nearest_name.h"

namespace macula::scene {

namespace {

template <class Item>
std::shared_ptr<const Item> byName(const std::vector<std::shared_ptr<const Item>>& items,
                                   std::string_view name) {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const auto& item) { return item->name == name; });
    return found == items.end() ? nullptr : *found;
}

template <class Item>
Result<std::shared_ptr<const Item>> findOrExplain(const std::vector<std::shared_ptr<const Item>>& items,
                                                  std::string_view name, Text sentence) {
    if (auto found = byName(items, name)) return found;
    std::vector<std::string> names;
    for (const auto& item : items) names.push_back(item->name);
    return noSuchName(std::move(sentence), std::string(name), names);
}

}  // namespace

Result<Catalogue> builtInCatalogue() {
    Catalogue catalogue;
    MACULA_TRY(const std::vector<TransferFunction> presets, presets::builtInPresets());
    for (const TransferFunction& function : presets) {
        // Offers only presets that can be drawn as intended.
        if (validate(function))
            catalogue.presets.push_back(std::make_shared<const TransferFunction>(function));
    }
    MACULA_TRY(std::vector<trace::LightRig> rigs, builtInLights());
    for (trace::LightRig& rig : rigs)
        catalogue.lights.push_back(std::make_shared<const trace::LightRig>(std::move(rig)));
    MACULA_TRY(std::vector<ClipPreset> clips, builtInClips());
    for (ClipPreset& clip : clips)
        catalogue.clips.push_back(std::make_shared<const ClipPreset>(std::move(clip)));
    MACULA_CHECK(!catalogue.presets.empty() && !catalogue.lights.empty());
    return catalogue;
}

Result<std::shared_ptr<const TransferFunction>> findPreset(const Catalogue& catalogue,
                                                           std::string_view name) {
    for (const auto& preset : catalogue.presets) {
        if (presets::isMeant(*preset, name)) return preset;
    }
    return findOrExplain(catalogue.presets, name, Text("There is no such preset."));
}

Result<std::shared_ptr<const trace::LightRig>> findLights(const Catalogue& catalogue, std::string_view name) {
    return findOrExplain(catalogue.lights, name, Text("There are no such lights."));
}

std::shared_ptr<const TransferFunction> presetFor(const Catalogue& catalogue, const Volume& volume) {
    auto preset = byName(catalogue.presets, presets::defaultTransfer(volume));
    MACULA_CHECK(preset != nullptr);
    return preset;
}

std::shared_ptr<const trace::LightRig> defaultLights(const Catalogue& catalogue, trace::Look look) {
    if (auto lights = byName(catalogue.lights, defaultLightsFor(look))) return lights;
    return catalogue.lights.front();
}

}  // namespace macula::scene
