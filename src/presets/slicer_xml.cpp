#include "presets/slicer_xml.h"

#include <algorithm>
#include <cmath>

#include "presets/numbers.h"
#include "presets/preset_name.h"
#include "presets/slicer_light.h"
#include "presets/vtk_curve.h"
#include "presets/xml_document.h"

namespace macula::presets {

namespace {

constexpr std::size_t kMostPresets = 1024;

// "0 -1" stands for none.
void readRange(pugi::xml_node node, ImportedPreset& preset) {
    const std::string text = node.attribute("effectiveRange").value();
    if (text.empty()) return;
    const std::optional<std::vector<double>> range = numbersFrom(text, 2);
    const auto isTooLarge = [](double value) { return std::abs(value) > kLargestValue; };
    if (!range || range->size() != 2 || std::any_of(range->begin(), range->end(), isTooLarge)) {
        preset.notes.push_back(Text("The effective range cannot be read and was left out: \"{}\".", text));
    } else if ((*range)[0] < (*range)[1]) {
        preset.function.effectiveRange = ValueRange{(*range)[0], (*range)[1]};
    }
}

Result<void> readLighting(pugi::xml_node node, const PresetText& file, TransferFunction& function) {
    Lighting& light = function.lighting;
    light.shade = node.attribute("shade").as_bool(light.shade);
    const auto read = [&](const char* key, double most, double& out) -> Result<void> {
        const pugi::xml_attribute attribute = node.attribute(key);
        if (!attribute || readLight(attribute.value(), most, out)) return {};
        return Error{ErrorCode::inputNotUsable,
                     Text("The {} of the preset {} is no number from 0 to {:g}.", key, function.title, most),
                     file.where, Text("Correct it, or remove it.")};
    };
    MACULA_TRY_VOID(read("ambient", 1e3, light.ambient));
    MACULA_TRY_VOID(read("diffuse", 1e3, light.diffuse));
    MACULA_TRY_VOID(read("specular", 1e3, light.specular));
    MACULA_TRY_VOID(read("specularPower", 1e6, light.specularPower));
    if (const pugi::xml_attribute type = node.attribute("interpolation")) {
        const std::optional<Interpolation> known = interpolationFrom(type.value());
        if (!known) {
            return Error{ErrorCode::inputNotUsable,
                         Text("The interpolation of the preset {} is unknown.", function.title), file.where,
                         Text("Use 0 for nearest or 1 for linear.")};
        }
        function.interpolation = *known;
    }
    return {};
}

Result<ImportedPreset> readPreset(pugi::xml_node node, const PresetText& file) {
    ImportedPreset preset;
    TransferFunction& function = preset.function;
    const std::string name = node.attribute("name").value();
    if (!nameAfter(function, name.empty() ? file.fallbackName : name))
        preset.notes.push_back(assumedHounsfield());
    function.source = "3D Slicer";

    bool clamped = false;
    MACULA_TRY(function.opacity,
               opacityFromText(node.attribute("scalarOpacity").value(),
                               Text("scalarOpacity of {}", function.title), file.where, clamped));
    MACULA_TRY(function.colour,
               colourFromText(node.attribute("colorTransfer").value(),
                              Text("colorTransfer of {}", function.title), file.where, clamped));
    if (const pugi::xml_attribute gradient = node.attribute("gradientOpacity")) {
        MACULA_TRY(function.gradientOpacity,
                   opacityFromText(gradient.value(), Text("gradientOpacity of {}", function.title),
                                   file.where, clamped));
    }
    MACULA_TRY_VOID(readLighting(node, file, function));
    readRange(node, preset);
    if (clamped) preset.notes.emplace_back(Text("Opacities or colours outside 0 to 1 were clamped."));
    return preset;
}

}  // namespace

Result<ImportedPresets> presetsFromSlicerXml(const PresetText& file) {
    MACULA_TRY(const XmlDocument document, XmlDocument::parse(file.text, file.where));
    ImportedPresets presets;
    for (const pugi::xml_node root : document.root().children()) {
        for (const pugi::xml_node node : root.children("VolumeProperty")) {
            if (presets.size() == kMostPresets) {
                return Error{ErrorCode::inputNotUsable, Text("The file holds too many presets."), file.where,
                             Text("Split it into files of at most {}.", kMostPresets)};
            }
            MACULA_TRY(ImportedPreset preset, readPreset(node, file));
            presets.push_back(std::move(preset));
        }
    }
    if (presets.empty()) {
        return Error{ErrorCode::inputNotUsable, Text("The file holds no volume property of 3D Slicer."),
                     file.where, Text("Give a presets.xml, or an MRML scene with volume rendering.")};
    }
    return presets;
}

}  // namespace macula::presets
