#include "presets/importers.h"

#include <algorithm>
#include <array>
#include <utility>

#include "pipeline/volume/json_reader.h"
#include "presets/preset_name.h"
#include "presets/vtk_curve.h"

namespace macula::presets {

namespace {

constexpr std::size_t kMostPresets = 4096;
constexpr JsonRange kValue{-kLargestValue, kLargestValue};
constexpr std::array<std::pair<std::string_view, ColourSpace>, 7> kSpaces{
    {{"RGB", ColourSpace::rgb},
     {"HSV", ColourSpace::hsv},
     {"Lab", ColourSpace::lab},
     {"CIELAB", ColourSpace::lab},
     {"Diverging", ColourSpace::diverging},
     {"DIVERGING", ColourSpace::diverging},
     {"Step", ColourSpace::step}}};

// A switch, written as 0 and 1, or as true and false.
bool isOn(const JsonNode& node, std::string_view key) {
    const auto found = node.find(key);
    if (!found) return false;
    return found->isNumber() ? found->number() != 0.0 : found->boolean();
}

// A flat list of numbers in groups; empty unless its length is a multiple of `perPoint`.
std::vector<double> groups(const JsonNode& list, std::size_t perPoint) {
    std::vector<double> numbers;
    const std::vector<JsonNode> items = list.items(perPoint, perPoint * kMostPoints);
    if (items.size() % perPoint != 0) {
        list.fail(Text("groups of {} numbers", perPoint));
        return numbers;
    }
    numbers.reserve(items.size());
    for (const JsonNode& item : items) numbers.push_back(item.number(kValue));
    return numbers;
}

// ParaView keeps several points at one value; the value itself has the height of the first.
std::vector<OpacityPoint> opacityFrom(const JsonNode& list, std::size_t perPoint) {
    const std::vector<double> numbers = groups(list, perPoint);
    std::vector<OpacityPoint> points;
    for (std::size_t i = 0; i < numbers.size(); i += perPoint) {
        OpacityPoint point{numbers[i], numbers[i + 1]};
        if (perPoint == 4) {
            point.midpoint = numbers[i + 2];
            point.sharpness = numbers[i + 3];
        }
        points.push_back(point);
    }
    sortAsAdded(points, true);
    return points;
}

std::vector<ColourPoint> colourFrom(const JsonNode& list) {
    const std::vector<double> numbers = groups(list, 4);
    std::vector<ColourPoint> points;
    for (std::size_t i = 0; i < numbers.size(); i += 4)
        points.push_back({numbers[i], {numbers[i + 1], numbers[i + 2], numbers[i + 3]}});
    sortAsAdded(points, true);
    return points;
}

ColourSpace spaceOf(const JsonNode& map) {
    const auto node = map.find("ColorSpace");
    if (!node) return ColourSpace::rgb;
    const std::string name = node->text();
    const auto* const known =
        std::find_if(kSpaces.begin(), kSpaces.end(), [&](const auto& entry) { return entry.first == name; });
    if (known == kSpaces.end()) {
        node->fail(Text("RGB, HSV, Lab, CIELAB, Diverging or Step"));
        return ColourSpace::rgb;
    }
    return known->second == ColourSpace::hsv && isOn(map, "HSVWrap") ? ColourSpace::hsvWrap : known->second;
}

ImportedPreset readMap(const JsonNode& map) {
    ImportedPreset preset;
    TransferFunction& function = preset.function;
    const bool known = nameAfter(function, map["Name"].text());
    const bool absolute = isOn(map, "AbsoluteRange");
    if (!map.find("RGBPoints") && map.find("IndexedColors"))
        map["IndexedColors"].fail(Text("a continuous colour map: categories cannot be drawn as one"));
    if (isOn(map, "UseLogScale")) map["UseLogScale"].fail(Text("a linear scale"));
    function.colourSpace = spaceOf(map);
    function.colour = colourFrom(map["RGBPoints"]);
    if (const auto points = map.find("OpacityPoints")) {
        function.opacity = opacityFrom(*points, 2);
    } else if (const auto curved = map.find("Points")) {
        function.opacity = opacityFrom(*curved, 4);
    } else if (!function.colour.empty()) {
        function.opacity = {{function.colour.front().value, 0.0}, {function.colour.back().value, 1.0}};
        preset.notes.emplace_back(
            Text("The colour map has no opacities; a ramp from 0 at its first to 1 at its last colour was "
                 "taken."));
    }
    if (const auto range = map.find("EffectiveRange")) {
        const std::vector<double> ends = range->numbers(2, kValue);
        if (ends[0] < ends[1]) function.effectiveRange = ValueRange{ends[0], ends[1]};
    }
    function.source = absolute ? "VolView" : "ParaView";
    if (absolute) {
        if (!known) preset.notes.push_back(assumedHounsfield());
    } else if (!function.colour.empty()) {
        function.unit = Unit::raw;
        if (!known) function.modalities.clear();
        const double low = function.colour.front().value;
        const double high = function.colour.back().value;
        if (!(low < high)) map["RGBPoints"].fail(Text("colours at two values or more"));
        function.fitToVolume = TransferFunction::Fit{low, high, TransferFunction::Fit::To::valueRange};
        function.effectiveRange = ValueRange{low, high};
    }
    return preset;
}

}  // namespace

Result<ImportedPresets> presetsFromParaviewJson(const PresetText& file) {
    const JsonDocument document(file.text, file.where, JsonComments::ignored);
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    ImportedPresets presets;
    if (!root.isList()) {
        presets.push_back(readMap(root));
    } else {
        for (const JsonNode& map : root.items(1, kMostPresets)) {
            presets.push_back(readMap(map));
            MACULA_TRY_VOID(document.status());
        }
    }
    MACULA_TRY_VOID(document.status());
    for (const ImportedPreset& preset : presets) {
        if (auto valid = validate(preset.function); !valid) {
            Error error = valid.error();
            error.where = file.where;
            return error;
        }
    }
    return presets;
}

}  // namespace macula::presets
