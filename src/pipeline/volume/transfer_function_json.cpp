#include "pipeline/volume/transfer_function_json.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "pipeline/volume/json_reader.h"
#include "pipeline/volume/json_writer.h"

namespace macula {

namespace {

using Json = nlohmann::ordered_json;
using Fit = TransferFunction::Fit;

constexpr std::size_t kMaxPoints = 4096;
constexpr JsonRange kFraction{0.0, 1.0};
constexpr JsonRange kPositive{1e-6, 1e6};
constexpr JsonRange kPhong{0.0, 1e3};
constexpr JsonRange kValue{-1e9, 1e9};
constexpr std::array<const char*, 3> kInterpolations{"nearest", "linear", "cubic"};

template <class Point, class ReadHeight>
std::vector<Point> readPoints(const JsonNode& curve, const ReadHeight& readHeight) {
    std::vector<Point> points;
    double last = std::numeric_limits<double>::lowest();
    for (const JsonNode& node : curve["points"].items(1, kMaxPoints)) {
        Point point;
        point.value = node["x"].number(kValue);
        readHeight(node, point);
        if (const auto midpoint = node.find("midpoint")) point.midpoint = midpoint->number(kFraction);
        if (const auto sharpness = node.find("sharpness")) point.sharpness = sharpness->number(kFraction);
        if (point.value < last) node["x"].fail(Text("points sorted by x: not below {}", last));
        last = point.value;
        points.push_back(point);
    }
    return points;
}

std::vector<OpacityPoint> readOpacity(const JsonNode& curve) {
    return readPoints<OpacityPoint>(curve, [](const JsonNode& node, OpacityPoint& point) {
        point.opacity = node["y"].number(kFraction);
    });
}

std::vector<ColourPoint> readColour(const JsonNode& curve) {
    return readPoints<ColourPoint>(curve, [](const JsonNode& node, ColourPoint& point) {
        const std::vector<double> rgb = node["color"].numbers(3, kFraction);
        point.colour = {rgb[0], rgb[1], rgb[2]};
    });
}

Unit unitFrom(const JsonNode& node) {
    const std::string unit = node.text();
    if (unit != "HU" && unit != "raw") node.fail(Text("\"HU\" or \"raw\""));
    return unit == "raw" ? Unit::raw : Unit::hounsfield;
}

// A name is typed on command lines and becomes a file name.
std::string nameFrom(const JsonNode& node) {
    std::string name = node.text();
    const bool valid = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    });
    if (!valid) node.fail(Text("lower-case letters, digits and hyphens"));
    return name;
}

// false, true, "foreground" (the same as true) or "valueRange".
std::optional<Fit::To> fitFrom(const JsonNode& node) {
    if (!node.isText()) return node.boolean() ? std::optional(Fit::To::foreground) : std::nullopt;
    const std::string to = node.text();
    if (to != "foreground" && to != "valueRange")
        node.fail(Text("true, false, \"foreground\" or \"valueRange\""));
    return to == "valueRange" ? Fit::To::valueRange : Fit::To::foreground;
}

Surface surfaceFrom(const JsonNode& node) {
    node.allowOnly({"weight", "gradientPerMm", "roughness", "reflectance"});
    Surface surface;
    surface.weight = node["weight"].number(kFraction);
    if (const auto gradient = node.find("gradientPerMm")) surface.gradientPerMm = gradient->number(kPositive);
    if (const auto roughness = node.find("roughness"))
        surface.roughness = roughness->number({kLeastRoughness, 1.0});
    if (const auto reflectance = node.find("reflectance"))
        surface.reflectance = reflectance->number(kFraction);
    return surface;
}

// The curves have the same form as those of the component. Either both are present, or none.
SteepMatter steepFrom(const JsonNode& node) {
    node.allowOnly({"gradientPerMm", "scalarOpacity", "rgbTransferFunction"});
    SteepMatter steep;
    if (const auto gradient = node.find("gradientPerMm")) steep.gradientPerMm = gradient->number(kPositive);
    if (!node.find("scalarOpacity") && !node.find("rgbTransferFunction")) return steep;
    steep.opacity = readOpacity(node["scalarOpacity"]);
    steep.colour = readColour(node["rgbTransferFunction"]);
    return steep;
}

void readVendorPart(const JsonNode& node, const JsonNode& property, TransferFunction& function) {
    if (node["version"].number() != 1.0)
        node["version"].fail(Text("version 1; newer ones need a newer Macula"));
    function.name = nameFrom(node["name"]);
    function.title = node["title"].text();
    function.modalities.clear();
    for (const JsonNode& modality : node["modality"].items(0, 64))
        function.modalities.push_back(modality.text());
    function.unit = unitFrom(node["unit"]);
    if (const auto number = node.find("number")) function.number = static_cast<int>(number->number({1, 1e6}));
    if (const auto source = node.find("source")) function.source = source->text();
    if (const auto albedo = node.find("albedo")) function.albedo = albedo->number(kFraction);
    if (const auto density = node.find("density")) function.density = density->number({1e-6, 1000.0});
    if (const auto surface = node.find("surface")) function.surface = surfaceFrom(*surface);
    if (const auto steep = node.find("steep")) function.steep = steepFrom(*steep);
    if (const auto space = node.find("colorSpace")) {
        const std::optional<ColourSpace> known = colourSpaceNamed(space->text());
        if (!known) space->fail(Text("\"rgb\", \"hsv\", \"hsvWrap\", \"lab\", \"diverging\" or \"step\""));
        function.colourSpace = known.value_or(ColourSpace::rgb);
    }
    if (const auto fit = node.find("fitToVolume")) {
        if (const auto to = fitFrom(*fit)) {
            const std::vector<double> range = property["effectiveRange"].numbers(2);
            if (!(range[0] < range[1])) property["effectiveRange"].fail(Text("two ascending numbers"));
            function.fitToVolume = Fit{range[0], range[1], *to};
        }
    }
}

void readProperty(const JsonNode& property, TransferFunction& function) {
    if (const auto g = property.find("scatteringAnisotropy"))
        function.anisotropy = g->number({-kMostScatteringAnisotropy, kMostScatteringAnisotropy});
    if (const auto type = property.find("interpolationType")) {
        const auto* const known = std::find(kInterpolations.begin(), kInterpolations.end(), type->text());
        if (known == kInterpolations.end()) return type->fail(Text("\"nearest\", \"linear\" or \"cubic\""));
        function.interpolation = static_cast<Interpolation>(known - kInterpolations.begin());
    }
    if (const auto node = property.find("effectiveRange")) {
        const std::vector<double> range = node->numbers(2, kValue);
        // 3D Slicer writes [0, -1] if there is none.
        if (range[0] < range[1]) function.effectiveRange = ValueRange{range[0], range[1]};
    }
}

void readComponent(const JsonNode& component, TransferFunction& function) {
    if (const auto distance = component.find("scalarOpacityUnitDistance")) {
        function.unitDistanceMm = distance->number(kPositive);
    }
    if (const auto shade = component.find("shade")) function.lighting.shade = shade->boolean();
    if (const auto lighting = component.find("lighting")) {
        Lighting& light = function.lighting;
        if (const auto ambient = lighting->find("ambient")) light.ambient = ambient->number(kPhong);
        if (const auto diffuse = lighting->find("diffuse")) light.diffuse = diffuse->number(kPhong);
        if (const auto specular = lighting->find("specular")) light.specular = specular->number(kPhong);
        if (const auto power = lighting->find("specularPower"))
            light.specularPower = power->number({0.0, 1e6});
    }
    const auto disabled = component.find("disableGradientOpacity");
    if (!disabled || !disabled->boolean()) {
        const auto gradient = component.find("gradientOpacity");
        // Some programs write an empty list for none.
        if (gradient && !(*gradient)["points"].items(0, kMaxPoints).empty())
            function.gradientOpacity = readOpacity(*gradient);
    }
    function.opacity = readOpacity(component["scalarOpacity"]);
    function.colour = readColour(component["rgbTransferFunction"]);
}

// Sets a value, but leaves an equal one as it is: 1024 is not rewritten as 1024.0.
void put(Json& object, const char* key, Json value) {
    if (const auto found = object.find(key); found != object.end() && *found == value) return;
    object[key] = std::move(value);
}

// Sets an optional key: a default value is left out if the document does not have the key.
void putUnless(bool isDefault, Json& object, const char* key, Json value) {
    if (!isDefault || object.contains(key)) put(object, key, std::move(value));
}

Json& child(Json& object, const char* key) {
    Json& value = object[key];
    if (!value.is_object()) value = Json::object();
    return value;
}

Json& firstOf(Json& object, const char* key) {
    Json& list = object[key];
    if (!list.is_array() || list.empty() || !list.front().is_object()) list = Json::array({Json::object()});
    return list.front();
}

// Writes the points as a list. A point with the same index and value as in the old list keeps its unknown
// keys.
template <class Point, class PutHeight>
void putPoints(Json& curve, const char* type, const std::vector<Point>& points, const PutHeight& putHeight) {
    if (!curve.contains("type")) curve["type"] = type;
    Json& old = curve["points"];
    Json list = Json::array();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& point = points[i];
        const bool stayed = old.is_array() && i < old.size() && old[i].is_object() && old[i].contains("x") &&
                            old[i]["x"] == point.value;
        Json node = stayed ? old[i] : Json::object();
        put(node, "x", point.value);
        putHeight(node, point);
        put(node, "midpoint", point.midpoint);
        put(node, "sharpness", point.sharpness);
        list.push_back(std::move(node));
    }
    old = std::move(list);
}

void putOpacity(Json& curve, const std::vector<OpacityPoint>& points) {
    putPoints(curve, "piecewiseLinearFunction", points,
              [](Json& node, const OpacityPoint& point) { put(node, "y", point.opacity); });
}

void putColour(Json& curve, const std::vector<ColourPoint>& points) {
    putPoints(curve, "colorTransferFunction", points, [](Json& node, const ColourPoint& point) {
        put(node, "color", {point.colour.r, point.colour.g, point.colour.b});
    });
}

void putSteep(Json& macula, const SteepMatter& steep) {
    if (steep == SteepMatter{} && !macula.contains("steep")) return;
    Json& node = child(macula, "steep");
    put(node, "gradientPerMm", steep.gradientPerMm);
    if (steep.opacity.empty()) {
        node.erase("scalarOpacity");
        node.erase("rgbTransferFunction");
        return;
    }
    putOpacity(child(node, "scalarOpacity"), steep.opacity);
    putColour(child(node, "rgbTransferFunction"), steep.colour);
}

void putVendorPart(Json& macula, const TransferFunction& function) {
    put(macula, "version", 1);
    put(macula, "name", function.name);
    put(macula, "title", function.title);
    if (function.number) {
        put(macula, "number", *function.number);
    } else {
        macula.erase("number");
    }
    putUnless(function.source.empty(), macula, "source", function.source);
    put(macula, "modality", function.modalities);
    put(macula, "unit", function.unit == Unit::hounsfield ? "HU" : "raw");
    putUnless(function.colourSpace == ColourSpace::rgb, macula, "colorSpace",
              std::string(colourSpaceName(function.colourSpace)));
    putUnless(function.albedo == 1.0, macula, "albedo", function.albedo);
    putUnless(function.density == 1.0, macula, "density", function.density);
    if (function.surface != Surface{} || macula.contains("surface")) {
        Json& surface = child(macula, "surface");
        put(surface, "weight", function.surface.weight);
        put(surface, "gradientPerMm", function.surface.gradientPerMm);
        put(surface, "roughness", function.surface.roughness);
        put(surface, "reflectance", function.surface.reflectance);
    }
    putSteep(macula, function.steep);
    const auto& fit = function.fitToVolume;
    Json wanted = fit.has_value();
    if (fit && fit->to == Fit::To::valueRange) wanted = "valueRange";
    const bool spelledOut =
        fit && fit->to == Fit::To::foreground && macula.value("fitToVolume", Json()) == "foreground";
    if (!spelledOut) putUnless(!fit, macula, "fitToVolume", std::move(wanted));
}

void putProperty(Json& property, const TransferFunction& function) {
    std::optional<ValueRange> range = function.effectiveRange;
    if (function.fitToVolume) range = ValueRange{function.fitToVolume->low, function.fitToVolume->high};
    if (range) {
        put(property, "effectiveRange", {range->low, range->high});
    } else if (const auto old = property.find("effectiveRange");
               old == property.end() || !old->is_array() || old->size() != 2 || (*old)[0] < (*old)[1]) {
        property["effectiveRange"] = {0.0, -1.0};
    }
    if (!property.contains("isoSurfaceValues")) property["isoSurfaceValues"] = Json::array();
    if (!property.contains("independentComponents")) property["independentComponents"] = true;
    put(property, "interpolationType", kInterpolations.at(static_cast<std::size_t>(function.interpolation)));
    put(property, "scatteringAnisotropy", function.anisotropy);
}

void putComponent(Json& component, const TransferFunction& function) {
    if (!component.contains("componentWeight")) component["componentWeight"] = 1.0;
    put(component, "shade", function.lighting.shade);
    Json& lighting = child(component, "lighting");
    put(lighting, "ambient", function.lighting.ambient);
    put(lighting, "diffuse", function.lighting.diffuse);
    put(lighting, "specular", function.lighting.specular);
    put(lighting, "specularPower", function.lighting.specularPower);
    put(component, "disableGradientOpacity", function.gradientOpacity.empty());
    put(component, "scalarOpacityUnitDistance", function.unitDistanceMm);
    putOpacity(child(component, "scalarOpacity"), function.opacity);
    if (!function.gradientOpacity.empty())
        putOpacity(child(component, "gradientOpacity"), function.gradientOpacity);
    putColour(child(component, "rgbTransferFunction"), function.colour);
}

}  // namespace

Result<TransferFunction> transferFunctionFromJson(std::string_view text, const std::string& where,
                                                  const std::string& fallbackName) {
    const JsonDocument document(text, where);
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    TransferFunction function;
    // Never empty: such a name could be written, but not read again.
    function.name = fallbackName.empty() ? "preset" : fallbackName;
    function.title = function.name;
    function.modalities = {"CT"};
    function.document = text;

    const std::vector<JsonNode> properties = root["volumeProperties"].items(1, 64);
    MACULA_TRY_VOID(document.status());
    const JsonNode& property = properties.front();
    const std::vector<JsonNode> components = property["components"].items(1, 64);
    MACULA_TRY_VOID(document.status());

    readProperty(property, function);
    if (const auto vendor = root.find("macula")) readVendorPart(*vendor, property, function);
    readComponent(components.front(), function);
    MACULA_TRY_VOID(document.status());
    if (auto valid = validate(function); !valid) {
        Error error = valid.error();
        error.where = where;
        return error;
    }
    return function;
}

std::string toJson(const TransferFunction& function) {
    Json document = Json::object();
    if (!function.document.empty()) document = Json::parse(function.document, nullptr, false);
    if (!document.is_object()) document = Json::object();
    if (!document.contains("@schema")) {
        document["@schema"] =
            "https://raw.githubusercontent.com/slicer/slicer/main/Modules/Loadable/VolumeRendering/"
            "Resources/Schema/volume-property-schema-v1.0.0.json#";
    }
    putVendorPart(child(document, "macula"), function);
    Json& property = firstOf(document, "volumeProperties");
    putProperty(property, function);
    putComponent(firstOf(property, "components"), function);
    return prettyJson(document);
}

}  // namespace macula
