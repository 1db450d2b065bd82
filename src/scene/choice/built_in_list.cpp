#include "scene/choice/built_in_list.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "presets/catalogue.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/quality_choice.h"

namespace macula::scene {

namespace {

nlohmann::ordered_json describeAsJson(const TransferFunction& preset) {
    nlohmann::ordered_json json = {{"name", preset.name},
                                   {"title", preset.title},
                                   {"number", nullptr},
                                   {"modality", preset.modalities},
                                   {"unit", unitOf(preset)},
                                   {"source", preset.source},
                                   {"fitted", preset.fitToVolume.has_value()}};
    if (preset.number) json["number"] = *preset.number;
    return json;
}

}  // namespace

Result<BuiltIns> builtIns() {
    BuiltIns all;
    MACULA_TRY(all.presets, presets::builtInPresets());
    MACULA_TRY(all.lights, builtInLights());
    MACULA_TRY(all.clips, builtInClips());
    MACULA_TRY(all.qualities, builtInQualities());
    return all;
}

nlohmann::ordered_json toJson(const BuiltIns& all) {
    nlohmann::ordered_json list = {{"presets", nlohmann::json::array()}, {"lights", nlohmann::json::array()}};
    for (const TransferFunction& preset : all.presets) list["presets"].push_back(describeAsJson(preset));
    for (const trace::LightRig& rig : all.lights)
        list["lights"].push_back({{"name", rig.name}, {"title", rig.title}});
    for (const ClipPreset& clip : all.clips)
        list["clips"].push_back({{"name", clip.name}, {"title", clip.title}});
    for (const trace::Quality& quality : all.qualities) {
        list["qualities"].push_back({{"name", quality.name},
                                     {"title", quality.title},
                                     {"samplesPerPixel", quality.samplesPerPixel},
                                     {"bounces", quality.bounces}});
    }
    return list;
}

std::string_view unitOf(const TransferFunction& preset) {
    return preset.unit == Unit::hounsfield ? "HU" : "raw";
}

std::vector<TransferFunction> withDifferentNames(std::span<const presets::ImportedPreset> imported) {
    std::set<std::string> taken;
    std::vector<TransferFunction> functions;
    for (const presets::ImportedPreset& preset : imported) {
        TransferFunction function = preset.function;
        for (int copy = 2; !taken.insert(function.name).second; ++copy)
            function.name = fmt::format("{}-{}", preset.function.name, copy);
        functions.push_back(std::move(function));
    }
    return functions;
}

}  // namespace macula::scene
