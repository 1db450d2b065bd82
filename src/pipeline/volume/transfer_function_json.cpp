#include "pipeline/volume/transfer_function_json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "pipeline/volume/json_reader.h"

namespace macula {

namespace {

constexpr std::size_t kMaxPoints = 4096;
constexpr JsonRange kFraction{0.0, 1.0};
constexpr JsonRange kPositive{1e-6, 1e6};

// How far between its two ends a segment has come at u in [0, 1]: vtkPiecewiseFunction's rule, whose midpoint
// and sharpness the file format borrows. 0.5 and 0 give a straight line.
double blend(double u, double midpoint, double sharpness) {
    midpoint = std::clamp(midpoint, 0.00001, 0.99999);
    u = u < midpoint ? 0.5 * u / midpoint : 0.5 + 0.5 * (u - midpoint) / (1.0 - midpoint);
    if (sharpness > 0.99) return u < 0.5 ? 0.0 : 1.0;
    if (sharpness < 0.01) return u;
    const double power = 1.0 + 10.0 * sharpness;
    u = u < 0.5 ? 0.5 * std::pow(2.0 * u, power) : 1.0 - 0.5 * std::pow(2.0 * (1.0 - u), power);
    const double tangents = (1.0 - sharpness) * (2.0 * u * u * u - 3.0 * u * u + u);
    return std::clamp(3.0 * u * u - 2.0 * u * u * u + tangents, 0.0, 1.0);
}

// One node of a curve in the file; `y` is an opacity or an RGB colour.
template <class Y>
struct FilePoint {
    double x = 0.0;
    Y y{};
    double midpoint = 0.5;
    double sharpness = 0.0;
};

template <class Y, class ReadY>
std::vector<FilePoint<Y>> readPoints(const JsonNode& curve, const ReadY& readY) {
    std::vector<FilePoint<Y>> points;
    double last = std::numeric_limits<double>::lowest();
    for (const JsonNode& node : curve["points"].items(1, kMaxPoints)) {
        FilePoint<Y> point;
        point.x = node["x"].number({-1e9, 1e9});
        point.y = readY(node);
        if (const auto midpoint = node.find("midpoint")) point.midpoint = midpoint->number(kFraction);
        if (const auto sharpness = node.find("sharpness")) point.sharpness = sharpness->number(kFraction);
        if (point.x < last) node["x"].fail(fmt::format("points sorted by x: not below {}", last));
        last = point.x;
        points.push_back(point);
    }
    return points;
}

// Calls add(x, y) for each point of the piecewise-linear curve that stands for `points`.
template <class Y, class Add>
void straighten(const std::vector<FilePoint<Y>>& points, const Add& add) {
    constexpr int kPieces = 32;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const FilePoint<Y>& from = points[i];
        add(from.x, from.y);
        const bool straight = from.midpoint == 0.5 && from.sharpness == 0.0;
        if (straight || i + 1 == points.size() || points[i + 1].x <= from.x) continue;
        const FilePoint<Y>& to = points[i + 1];
        for (int piece = 1; piece < kPieces; ++piece) {
            const double u = static_cast<double>(piece) / kPieces;
            add(from.x + u * (to.x - from.x),
                from.y + blend(u, from.midpoint, from.sharpness) * (to.y - from.y));
        }
    }
}

Unit unitFrom(const JsonNode& node) {
    const std::string unit = node.text();
    if (unit != "HU" && unit != "raw") node.fail("\"HU\" or \"raw\"");
    return unit == "raw" ? Unit::raw : Unit::hounsfield;
}

// A name is typed on command lines and becomes a file name.
std::string nameFrom(const JsonNode& node) {
    std::string name = node.text();
    const bool valid = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    });
    if (!valid) node.fail("lower-case letters, digits and hyphens");
    return name;
}

void readVendorPart(const JsonNode& node, const JsonNode& property, TransferFunction& function) {
    if (node["version"].number() != 1.0) node["version"].fail("version 1; newer ones need a newer Macula");
    function.name = nameFrom(node["name"]);
    function.title = node["title"].text();
    function.modalities.clear();
    for (const JsonNode& modality : node["modality"].items(0, 64))
        function.modalities.push_back(modality.text());
    function.unit = unitFrom(node["unit"]);
    if (const auto albedo = node.find("albedo")) function.albedo = albedo->number(kFraction);
    if (const auto density = node.find("density")) function.density = density->number({1e-6, 1000.0});
    if (const auto fit = node.find("fitToVolume"); fit && fit->boolean()) {
        const std::vector<double> range = property["effectiveRange"].numbers(2);
        if (!(range[0] < range[1])) property["effectiveRange"].fail("two ascending numbers");
        function.fitToVolume = TransferFunction::Fit{range[0], range[1]};
    }
}

}  // namespace

Result<TransferFunction> transferFunctionFromJson(std::string_view text, const std::string& where,
                                                  const std::string& fallbackName) {
    const JsonDocument document(text, where);
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    TransferFunction function;
    function.name = fallbackName;
    function.title = fallbackName;
    function.modalities = {"CT"};

    const std::vector<JsonNode> properties = root["volumeProperties"].items(1, 64);
    MACULA_TRY_VOID(document.status());
    const JsonNode& property = properties.front();
    const std::vector<JsonNode> components = property["components"].items(1, 64);
    MACULA_TRY_VOID(document.status());
    const JsonNode& component = components.front();

    if (const auto vendor = root.find("macula")) readVendorPart(*vendor, property, function);
    if (const auto g = property.find("scatteringAnisotropy")) function.anisotropy = g->number({-0.99, 0.99});
    if (const auto distance = component.find("scalarOpacityUnitDistance")) {
        function.unitDistanceMm = distance->number(kPositive);
    }
    const auto opacity = readPoints<double>(component["scalarOpacity"],
                                            [](const JsonNode& node) { return node["y"].number(kFraction); });
    const auto colour = readPoints<glm::dvec3>(component["rgbTransferFunction"], [](const JsonNode& node) {
        const std::vector<double> rgb = node["color"].numbers(3, kFraction);
        return glm::dvec3(rgb[0], rgb[1], rgb[2]);
    });
    MACULA_TRY_VOID(document.status());

    straighten(opacity, [&](double x, double y) { function.opacity.push_back({x, y}); });
    straighten(colour, [&](double x, const glm::dvec3& y) { function.colour.push_back({x, y}); });
    if (auto valid = validate(function); !valid) {
        Error error = valid.error();
        error.where = where;
        return error;
    }
    return function;
}

std::string toJson(const TransferFunction& function) {
    using Json = nlohmann::ordered_json;
    Json opacity = Json::array();
    for (const OpacityPoint& point : function.opacity) {
        opacity.push_back({{"x", point.value}, {"y", point.opacity}, {"midpoint", 0.5}, {"sharpness", 0.0}});
    }
    Json colour = Json::array();
    for (const ColourPoint& point : function.colour) {
        colour.push_back({{"x", point.value},
                          {"color", {point.colour.r, point.colour.g, point.colour.b}},
                          {"midpoint", 0.5},
                          {"sharpness", 0.0}});
    }
    Json macula = {{"version", 1},
                   {"name", function.name},
                   {"title", function.title},
                   {"modality", function.modalities},
                   {"unit", function.unit == Unit::hounsfield ? "HU" : "raw"},
                   {"fitToVolume", function.fitToVolume.has_value()},
                   {"albedo", function.albedo},
                   {"density", function.density}};
    Json component = {
        {"componentWeight", 1.0},
        {"shade", true},
        {"lighting", {{"diffuse", 0.9}, {"ambient", 0.1}, {"specular", 0.2}, {"specularPower", 10.0}}},
        {"disableGradientOpacity", true},
        {"scalarOpacityUnitDistance", function.unitDistanceMm},
        {"scalarOpacity", {{"type", "piecewiseLinearFunction"}, {"points", opacity}}},
        {"rgbTransferFunction", {{"type", "colorTransferFunction"}, {"points", colour}}}};
    const double low = function.fitToVolume ? function.fitToVolume->low : function.opacity.front().value;
    const double high = function.fitToVolume ? function.fitToVolume->high : function.opacity.back().value;
    Json property = {{"effectiveRange", {low, high}},
                     {"isoSurfaceValues", {0.0}},
                     {"independentComponents", true},
                     {"interpolationType", "linear"},
                     {"useClippedVoxelIntensity", false},
                     {"clippedVoxelIntensity", -1e10},
                     {"scatteringAnisotropy", function.anisotropy},
                     {"components", Json::array({component})}};
    const Json document = {
        {"@schema",
         "https://raw.githubusercontent.com/slicer/slicer/main/Modules/Loadable/VolumeRendering/"
         "Resources/Schema/volume-property-schema-v1.0.0.json#"},
        {"macula", macula},
        {"volumeProperties", Json::array({property})}};
    return document.dump(4) + "\n";
}

}  // namespace macula
