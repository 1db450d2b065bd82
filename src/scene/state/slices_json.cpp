#include "scene/state/slices_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/volume/json_reader.h"
#include "scene/state/json_names.h"
#include "scene/state/json_vectors.h"
#include "slices/sampled_slice.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> kWindowFunctions{"LINEAR", "LINEAR_EXACT", "SIGMOID"};

bool isWindowFunction(std::string_view name) {
    return std::ranges::find(kWindowFunctions, name) != kWindowFunctions.end();
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
    return std::abs(length - 1.0) < kUnitRounding ? turn : turn / length;
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

}  // namespace macula::scene
