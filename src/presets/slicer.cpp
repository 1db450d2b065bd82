#include "presets/importers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parsing.h"
#include "presets/preset_name.h"
#include "presets/vtk_curve.h"
#include "presets/xml_document.h"

namespace macula::presets {

namespace {

constexpr std::size_t kMostPresets = 1024;

// Returns whether `text` is a number from 0 to `most`, and sets `out` to it.
bool readLight(std::string_view text, double most, double& out) {
    const std::optional<double> number = finiteNumber(text);
    if (!number || *number < 0.0 || *number > most) return false;
    out = *number;
    return true;
}

// "0" nearest, "1" linear, "2" cubic.
std::optional<Interpolation> interpolationFrom(std::string_view text) {
    const std::optional<double> number = finiteNumber(text);
    if (!number) return std::nullopt;
    if (*number == 0.0) return Interpolation::nearest;
    if (*number == 1.0) return Interpolation::linear;
    if (*number == 2.0) return Interpolation::cubic;
    return std::nullopt;
}

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

namespace {

constexpr std::size_t kLines = 9;

// The non-blank lines. Fails unless there are nine.
Result<std::array<std::string_view, kLines>> linesOf(const PresetText& file) {
    std::array<std::string_view, kLines> lines;
    std::size_t count = 0;
    std::string_view rest = file.text;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        if (line.find_first_not_of(" \t\r") != std::string_view::npos) {
            if (count < kLines) lines.at(count) = line;
            ++count;
        }
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    }
    if (count == kLines) return lines;
    return Error{ErrorCode::inputNotUsable,
                 Text("A .vp file of 3D Slicer has {} lines; this has {}.", kLines, count), file.where,
                 Text("Check that it is complete.")};
}

}  // namespace

Result<ImportedPresets> presetsFromSlicerVp(const PresetText& file) {
    MACULA_TRY(const auto lines, linesOf(file));
    const auto fail = [&](std::size_t line, Text expected) {
        return Error{ErrorCode::inputNotUsable, Text("Line {} is not as expected.", line + 1), file.where,
                     Text("Expected {}.", std::move(expected))};
    };
    ImportedPreset preset;
    TransferFunction& function = preset.function;
    if (!nameAfter(function, file.fallbackName)) preset.notes.push_back(assumedHounsfield());
    function.source = "3D Slicer";

    const std::optional<Interpolation> interpolation = interpolationFrom(lines[0]);
    if (!interpolation) return fail(0, Text("the interpolation, 0 for nearest or 1 for linear"));
    function.interpolation = *interpolation;
    const std::optional<double> shade = finiteNumber(lines[1]);
    if (!shade || (*shade != 0.0 && *shade != 1.0)) return fail(1, Text("whether it is shaded, 0 or 1"));
    Lighting& light = function.lighting;
    light.shade = *shade == 1.0;
    if (!readLight(lines[2], 1e3, light.diffuse)) return fail(2, Text("the diffuse coefficient, 0 or above"));
    if (!readLight(lines[3], 1e3, light.ambient)) return fail(3, Text("the ambient coefficient, 0 or above"));
    if (!readLight(lines[4], 1e3, light.specular))
        return fail(4, Text("the specular coefficient, 0 or above"));
    if (!readLight(lines[5], 1e6, light.specularPower))
        return fail(5, Text("the specular power, 0 or above"));

    bool clamped = false;
    MACULA_TRY(function.opacity,
               opacityFromText(lines[6], Text("scalar opacity (line 7)"), file.where, clamped));
    MACULA_TRY(function.gradientOpacity,
               opacityFromText(lines[7], Text("gradient opacity (line 8)"), file.where, clamped));
    MACULA_TRY(function.colour, colourFromText(lines[8], Text("colour (line 9)"), file.where, clamped));
    if (clamped) preset.notes.emplace_back(Text("Opacities or colours outside 0 to 1 were clamped."));
    return ImportedPresets{std::move(preset)};
}

}  // namespace macula::presets
