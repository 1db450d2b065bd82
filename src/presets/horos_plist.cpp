#include "presets/importers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/parsing.h"
#include "pipeline/volume/json_reader.h"
#include "presets/preset_name.h"
#include "presets/vtk_curve.h"
#include "presets/xml_document.h"

namespace macula::presets {

namespace {

using Json = nlohmann::json;

// XmlDocument bounds the depth of the recursion.
class Converter {
  public:
    explicit Converter(const std::string& where) : where_(where) {}

    Result<Json> value(pugi::xml_node node) const {
        const std::string_view type = node.name();
        const std::string_view text = node.child_value();
        if (type == "dict") return dict(node);
        if (type == "array") return array(node);
        if (type == "string" || type == "date" || type == "data") return Json(std::string(text));
        if (type == "true" || type == "false") return Json(type == "true");
        if (type == "real" || type == "integer") {
            const std::optional<double> number = finiteNumber(text);
            if (number) return Json(*number);
            return fail(Text("holds a number that cannot be read"));
        }
        return fail(Text("holds <{}>, which no property list does", type));
    }

  private:
    Result<Json> dict(pugi::xml_node node) const {
        Json object = Json::object();
        std::string key;
        bool haveKey = false;
        for (const pugi::xml_node child : node.children()) {
            if (child.type() != pugi::node_element) continue;
            const bool isKey = std::string_view(child.name()) == "key";
            if (isKey == haveKey) return fail(Text("has a key without a value, or a value without a key"));
            if (isKey) {
                key = child.child_value();
            } else {
                MACULA_TRY(object[key], value(child));
            }
            haveKey = isKey;
        }
        if (haveKey) return fail(Text("has a key without a value, or a value without a key"));
        return object;
    }

    Result<Json> array(pugi::xml_node node) const {
        Json list = Json::array();
        for (const pugi::xml_node child : node.children()) {
            if (child.type() != pugi::node_element) continue;
            MACULA_TRY(Json item, value(child));
            list.push_back(std::move(item));
        }
        return list;
    }

    Error fail(Text what) const {
        return Error{ErrorCode::inputNotUsable, Text("The property list {}.", std::move(what)), where_,
                     Text("Check that it is complete.")};
    }

    const std::string& where_;
};

// Converts Apple's property lists from XML to JSON, so that JSON readers can read them: dict, array, string,
// date and data (both as text), real, integer, true, false. Fails with inputNotUsable for text that is not a
// property list, and for the binary form.
Result<Json> jsonFromPropertyList(std::string_view text, const std::string& where) {
    if (text.starts_with("bplist")) {
        return Error{ErrorCode::inputNotUsable, Text("The property list is in its binary form."), where,
                     Text("Convert it on a Mac: plutil -convert xml1 FILE.")};
    }
    MACULA_TRY(const XmlDocument document, XmlDocument::parse(text, where));
    for (const pugi::xml_node child : document.root().child("plist").children()) {
        if (child.type() == pugi::node_element) return Converter(where).value(child);
    }
    return Error{ErrorCode::inputNotUsable, Text("The file is no property list."), where,
                 Text("Check that it is complete.")};
}

constexpr std::size_t kMostCurves = 64;
constexpr std::size_t kTable = 256;
constexpr JsonRange kFraction{0.0, 1.0};
constexpr JsonRange kValue{-kLargestValue, kLargestValue};

struct NamedLight {
    std::string_view name;
    Lighting light;
};
constexpr std::array<NamedLight, 4> kLights{{{"Default", {true, 0.15, 0.9, 0.3, 15.0}},
                                             {"Glossy Vascular", {true, 0.15, 0.28, 1.42, 50.0}},
                                             {"Glossy Bone", {true, 0.15, 0.24, 1.17, 6.98}},
                                             {"Endoscopy", {true, 0.12, 0.64, 0.73, 50.0}}}};

std::string textOr(const JsonNode& node, std::string_view key, const std::string& fallback) {
    const auto found = node.find(key);
    return found ? found->text() : fallback;
}

bool flag(const JsonNode& node, std::string_view key) {
    const auto found = node.find(key);
    return found && found->boolean();
}

// Curves and colours are parallel lists of lists.
void readCurves(const JsonNode& root, TransferFunction& function) {
    const std::vector<JsonNode> curves = root["16bitClutCurves"].items(1, kMostCurves);
    const std::vector<JsonNode> colours = root["16bitClutColors"].items(curves.size(), curves.size());
    for (std::size_t c = 0; c < std::min(curves.size(), colours.size()); ++c) {
        const std::vector<JsonNode> points = curves[c].items(1, kMostPoints / kMostCurves);
        const std::vector<JsonNode> shades = colours[c].items(points.size(), points.size());
        for (std::size_t i = 0; i < std::min(points.size(), shades.size()); ++i) {
            const double value = points[i]["x"].number(kValue);
            const double height = points[i]["y"].number(kFraction);
            function.opacity.push_back({value, height * height});
            function.colour.push_back(
                {value,
                 {shades[i]["red"].number(kFraction), shades[i]["green"].number(kFraction),
                  shades[i]["blue"].number(kFraction)}});
        }
    }
    // All curves are added to one function, as VTK adds points.
    sortAsAdded(function.opacity, false);
    sortAsAdded(function.colour, false);
}

struct Window {
    double level = 0.0;
    double width = 1.0;
    double at(std::size_t entry) const {
        return level - 0.5 * width + width * static_cast<double>(entry) / (kTable - 1.0);
    }
};

// The three built-in tables of Horos; `entry` from 0 to 255.
std::optional<double> namedOpacity(std::string_view name, std::size_t entry) {
    const double u = static_cast<double>(entry) / (kTable - 1.0);
    if (name == "Linear Table") return u;
    if (name == "Logarithmic Table") return std::log10(1.0 + 9.0 * u);
    if (name == "Logarithmic Inverse Table") return 1.0 - std::log10(1.0 + 9.0 * (1.0 - u));
    return std::nullopt;
}

Result<void> readOpacityTable(const JsonNode& root, const Window& window, const PresetText& file,
                              TransferFunction& function) {
    const std::string name = textOr(root, "opacity", "Linear Table");
    for (std::size_t entry = 0; entry < kTable; ++entry) {
        const std::optional<double> opacity = namedOpacity(name, entry);
        if (!opacity) {
            return Error{
                ErrorCode::inputNotUsable,
                Text("The preset names the opacity table '{}', which is not in the file.", name), file.where,
                Text("Choose a built-in opacity table, or a 16-bit CLUT, and save the preset again.")};
        }
        function.opacity.push_back({window.at(entry), std::min(*opacity, 1.0)});
    }
    return {};
}

Result<void> readColourTable(const std::string& name, const Window& window, const PresetText& file,
                             const FindColourTable& findTable, TransferFunction& function) {
    if (name == "No CLUT") {
        function.colour = {{window.at(0), glm::dvec3(0.0)}, {window.at(kTable - 1), glm::dvec3(1.0)}};
        return {};
    }
    MACULA_TRY(const std::string text, findTable(name));
    MACULA_TRY(const nlohmann::json table, jsonFromPropertyList(text, file.where));
    const JsonDocument document = JsonDocument::of(table, file.where);
    constexpr JsonRange kByte{0.0, 255.0};
    const std::vector<double> red = document.root()["Red"].numbers(kTable, kByte);
    const std::vector<double> green = document.root()["Green"].numbers(kTable, kByte);
    const std::vector<double> blue = document.root()["Blue"].numbers(kTable, kByte);
    MACULA_TRY_VOID(document.status());
    for (std::size_t entry = 0; entry < kTable; ++entry)
        function.colour.push_back(
            {window.at(entry), glm::dvec3(red[entry], green[entry], blue[entry]) / 255.0});
    return {};
}

void readLight(const JsonNode& root, ImportedPreset& preset) {
    if (!flag(root, "useShading")) {
        preset.function.lighting.shade = false;
        return;
    }
    const std::string name = textOr(root, "shading", "Default");
    const auto* const known = std::find_if(kLights.begin(), kLights.end(),
                                           [&](const NamedLight& light) { return light.name == name; });
    preset.function.lighting = known == kLights.end() ? kLights.front().light : known->light;
    if (known == kLights.end())
        preset.notes.push_back(Text("The shading '{}' is not known; the default shading was taken.", name));
}

}  // namespace

Result<ImportedPresets> presetsFromHorosPlist(const PresetText& file, const FindColourTable& findTable) {
    MACULA_TRY(const nlohmann::json list, jsonFromPropertyList(file.text, file.where));
    const JsonDocument document = JsonDocument::of(list, file.where);
    const JsonNode root = document.root();
    ImportedPreset preset;
    TransferFunction& function = preset.function;
    if (!nameAfter(function, textOr(root, "name", file.fallbackName)))
        preset.notes.push_back(assumedHounsfield());
    function.source = "Horos";
    readLight(root, preset);
    if (const auto filters = root.find("convolutionFilters"); filters && !filters->items(0, 64).empty())
        preset.notes.emplace_back(Text("The filters of the preset are not applied."));
    const std::string table = textOr(root, "CLUT", "");
    const bool advanced = flag(root, "advancedCLUT") || root.find("16bitClutCurves").has_value();
    if (advanced) readCurves(root, function);
    Window window;
    if (!advanced) {
        window.level = root["wl"].number(kValue);
        window.width = root["ww"].number({1e-6, kLargestValue});
        if (std::max(-window.at(0), window.at(kTable - 1)) > kLargestValue)
            root["ww"].fail(Text("a window within -1e9 to 1e9"));
    }
    MACULA_TRY_VOID(document.status());
    if (!advanced) {
        MACULA_TRY_VOID(readOpacityTable(root, window, file, function));
        MACULA_TRY_VOID(readColourTable(table, window, file, findTable, function));
        MACULA_TRY_VOID(document.status());
        function.effectiveRange = ValueRange{window.at(0), window.at(kTable - 1)};
    }
    return ImportedPresets{std::move(preset)};
}

}  // namespace macula::presets
