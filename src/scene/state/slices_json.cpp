#include "scene/state/slices_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/utf8.h"
#include "pipeline/volume/json_reader.h"
#include "scene/state/json_names.h"
#include "slices/sampled_slice.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;
using slices::Angle;
using slices::Distance;
using slices::Ellipse;
using slices::Measurement;

constexpr JsonRange kAnyMm{-1e6, 1e6};
constexpr JsonRange kRadiusMm{0.0, 1e6};
constexpr std::array<std::string_view, 3> kWindowFunctions{"LINEAR", "LINEAR_EXACT", "SIGMOID"};

// The error in the length of a unit vector in double precision.
constexpr double kRounding = 1e-12;
constexpr double kPerpendicular = 1e-3;  // cosines up to this count as a right angle

bool isWindowFunction(std::string_view name) {
    return std::ranges::find(kWindowFunctions, name) != kWindowFunctions.end();
}

Json list(const glm::dvec3& v) {
    return Json{v.x, v.y, v.z};
}

glm::dvec3 vector(const JsonNode& node) {
    const std::vector<double> xyz = node.numbers(3, kAnyMm);
    return {xyz[0], xyz[1], xyz[2]};
}

glm::dvec3 direction(const JsonNode& node) {
    const glm::dvec3 v = vector(node);
    const double length = glm::length(v);
    if (!(length > 1e-6)) {
        node.fail(Text("a direction, not all zeros"));
        return {0.0, 0.0, 1.0};
    }
    return std::abs(length - 1.0) < kRounding ? v : v / length;
}

// A unit quaternion; the same bits if it already is one.
glm::dquat turnFrom(const JsonNode& node) {
    const std::vector<double> wxyz = node.numbers(4, {-1.0, 1.0});
    const glm::dquat turn(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    const double length = glm::length(turn);
    if (!(length > 1e-6)) {
        node.fail(Text("a turn, not all zeros"));
        return {1.0, 0.0, 0.0, 0.0};
    }
    return std::abs(length - 1.0) < kRounding ? turn : turn / length;
}

std::vector<glm::dvec3> curveFrom(const JsonNode& node) {
    std::vector<glm::dvec3> pointsMm;
    for (const JsonNode& item : node.items(0, kMostCurvePoints)) pointsMm.push_back(vector(item));
    return pointsMm;
}

slices::Slab slabFrom(const JsonNode& node) {
    node.allowOnly({"thicknessMm", "projection"});
    slices::Slab slab;
    if (const auto thickness = node.find("thicknessMm"))
        slab.thicknessMm = thickness->number({0.0, kThickestSlabMm});
    readName(node, "projection", slices::kProjections, slab.projection);
    return slab;
}

// Reads as many points as the shape has.
template <std::size_t count>
std::array<glm::dvec3, count> pointsFrom(const JsonNode& node) {
    std::array<glm::dvec3, count> points{};
    const std::vector<JsonNode> items = node.items(count, count);
    for (std::size_t i = 0; i < items.size(); ++i) points.at(i) = vector(items[i]);
    return points;
}

Ellipse ellipseFrom(const JsonNode& node) {
    Ellipse ellipse;
    ellipse.plane.centreMm = vector(node["centreMm"]);
    glm::dvec3& right = ellipse.plane.right;
    glm::dvec3& down = ellipse.plane.down;
    right = direction(node["right"]);
    down = direction(node["down"]);
    const double cosine = glm::dot(right, down);
    if (!(std::abs(cosine) <= kPerpendicular))
        node["down"].fail(Text("a direction perpendicular to \"right\""));
    if (std::abs(cosine) > kRounding) down = glm::normalize(down - cosine * right);
    const std::vector<double> radii = node["radiiMm"].numbers(2, kRadiusMm);
    ellipse.radiiMm = {radii[0], radii[1]};
    return ellipse;
}

Measurement measurementFrom(const JsonNode& node) {
    Measurement measurement;
    if (const auto label = node.find("label")) {
        measurement.label = label->text();
        if (measurement.label.size() > kLongestLabelBytes)
            label->fail(Text("at most {} bytes", kLongestLabelBytes));
    }
    measurement.normal = direction(node["normal"]);
    const JsonNode kind = node["kind"];
    const std::string name = kind.text();
    if (name == slices::kindOf({.shape = Distance{}})) {
        node.allowOnly({"kind", "label", "pointsMm", "normal"});
        measurement.shape = Distance{pointsFrom<2>(node["pointsMm"])};
    } else if (name == slices::kindOf({.shape = Angle{}})) {
        node.allowOnly({"kind", "label", "pointsMm", "normal"});
        measurement.shape = Angle{pointsFrom<3>(node["pointsMm"])};
    } else if (name == slices::kindOf({.shape = Ellipse{}})) {
        node.allowOnly({"kind", "label", "centreMm", "right", "down", "radiiMm", "normal"});
        measurement.shape = ellipseFrom(node);
    } else {
        kind.fail(Text("\"distance\", \"angle\" or \"ellipse\""));
    }
    return measurement;
}

template <class From>
bool isTaken(const Json& json, const From& from) {
    const JsonDocument document = JsonDocument::of(nlohmann::json(json), {});
    from(document.root());
    return document.status().ok();
}

// The label as it will be read: writing JSON replaces bytes that are not UTF-8.
std::string writtenLabel(const std::string& label) {
    const std::string text =
        Json::parse(Json(label).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
    return std::string(startOf(text, kLongestLabelBytes));
}

}  // namespace

Json windowJson(const DisplayWindow& from) {
    Json window{{"center", from.center}, {"width", from.width}};
    if (isWindowFunction(from.function)) window["function"] = from.function;
    return isTaken(window, windowFrom) ? window : Json();
}

DisplayWindow windowFrom(const JsonNode& node) {
    node.allowOnly({"center", "width", "function"});
    DisplayWindow window{.center = node["center"].number({-1e9, 1e9}),
                         .width = node["width"].number({1e-9, 1e9}),
                         .explanation = {},
                         .function = {}};
    if (const auto function = node.find("function")) {
        window.function = function->text();
        if (!isWindowFunction(window.function))
            function->fail(Text("\"LINEAR\", \"LINEAR_EXACT\" or \"SIGMOID\""));
    }
    return window;
}

Json toJson(const SliceState& state) {
    Json json = Json::object();
    if (state.window) {
        if (Json window = windowJson(*state.window); !window.is_null()) json["window"] = std::move(window);
    }
    if (state.slab != slices::Slab{}) {
        const Json slab{{"thicknessMm", state.slab.thicknessMm},
                        {"projection", nameOf(state.slab.projection)}};
        if (isTaken(slab, slabFrom)) json["slab"] = slab;
    }
    if (state.isInverted) json["inverted"] = true;
    if (state.asAcquired) json["asAcquired"] = true;
    if (state.crosshairMm) {
        const Json crosshair = list(*state.crosshairMm);
        if (isTaken(crosshair, vector)) json["crosshairMm"] = crosshair;
    }
    if (state.turn) {
        const Json turn{state.turn->w, state.turn->x, state.turn->y, state.turn->z};
        if (isTaken(turn, turnFrom)) json["turn"] = turn;
    }
    if (!state.curveMm.empty()) {
        Json curve = Json::array();
        for (const glm::dvec3& mm : state.curveMm) curve.push_back(list(mm));
        if (isTaken(curve, curveFrom)) json["curveMm"] = std::move(curve);
    }
    if (state.colours) json["colours"] = nameOf(*state.colours);
    return json;
}

Json toJson(const Measurement& measurement) {
    Json json{{"kind", slices::kindOf(measurement)}};
    if (!measurement.label.empty()) json["label"] = measurement.label;
    if (const auto* ellipse = std::get_if<Ellipse>(&measurement.shape)) {
        json["centreMm"] = list(ellipse->plane.centreMm);
        json["right"] = list(ellipse->plane.right);
        json["down"] = list(ellipse->plane.down);
        json["radiiMm"] = {ellipse->radiiMm.x, ellipse->radiiMm.y};
    } else {
        for (const glm::dvec3& mm : slices::pointsOf(measurement)) json["pointsMm"].push_back(list(mm));
    }
    json["normal"] = list(measurement.normal);
    return json;
}

Json measurementsJson(std::span<const Measurement> measurements) {
    Json all = Json::array();
    for (Measurement measurement : measurements) {
        if (all.size() == kMostMeasurements) break;
        measurement.label = writtenLabel(measurement.label);
        Json json = toJson(measurement);
        if (isTaken(json, measurementFrom)) all.push_back(std::move(json));
    }
    return all;
}

SliceState sliceStateFrom(const JsonNode& node) {
    node.allowOnly({"window", "slab", "inverted", "asAcquired", "crosshairMm", "turn", "curveMm", "colours"});
    SliceState state;
    if (const auto window = node.find("window")) state.window = windowFrom(*window);
    if (const auto slab = node.find("slab")) state.slab = slabFrom(*slab);
    if (const auto inverted = node.find("inverted")) state.isInverted = inverted->boolean();
    if (const auto asAcquired = node.find("asAcquired")) state.asAcquired = asAcquired->boolean();
    if (const auto crosshair = node.find("crosshairMm")) state.crosshairMm = vector(*crosshair);
    if (const auto turn = node.find("turn")) state.turn = turnFrom(*turn);
    if (const auto curve = node.find("curveMm")) state.curveMm = curveFrom(*curve);
    if (node.find("colours")) readName(node, "colours", slices::kColourTables, state.colours.emplace());
    return state;
}

std::vector<Measurement> measurementsFrom(const JsonNode& node) {
    std::vector<Measurement> measurements;
    for (const JsonNode& item : node.items(0, kMostMeasurements))
        measurements.push_back(measurementFrom(item));
    return measurements;
}

}  // namespace macula::scene
