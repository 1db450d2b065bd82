#include "scene/state/isodoses_json.h"

#include <cmath>
#include <limits>
#include <utility>

#include "pipeline/volume/json_reader.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr JsonRange kLevels{std::numeric_limits<double>::min(), kHighestIsodose};
constexpr JsonRange kOfColour{0.0, 255.0};

Isodose isodoseFrom(const JsonNode& node) {
    node.allowOnly({"level", "rgb"});
    Isodose isodose{.level = node["level"].number(kLevels)};
    const std::vector<double> rgb = node["rgb"].numbers(3, kOfColour);
    for (std::size_t c = 0; c < isodose.rgb.size(); ++c)
        isodose.rgb[c] = static_cast<std::uint8_t>(std::lround(rgb[c]));
    return isodose;
}

}  // namespace

Json toJson(const Isodoses& isodoses) {
    Json json{{"shown", isodoses.areShown}, {"unit", isodoses.areInPercent ? "percent" : "dose"}};
    if (isodoses.reference) json["reference"] = *isodoses.reference;
    json["levels"] = Json::array();
    for (const Isodose& each : isodoses.levels)
        json["levels"].push_back(Json{{"level", each.level}, {"rgb", each.rgb}});
    return json;
}

Isodoses isodosesFrom(const JsonNode& node) {
    node.allowOnly({"shown", "unit", "reference", "levels"});
    Isodoses isodoses;
    if (const auto shown = node.find("shown")) isodoses.areShown = shown->boolean();
    if (const auto unit = node.find("unit")) {
        const std::string name = unit->text();
        if (name != "percent" && name != "dose") unit->fail(Text("\"percent\" or \"dose\""));
        isodoses.areInPercent = name != "dose";
    }
    if (const auto reference = node.find("reference")) isodoses.reference = reference->number(kLevels);
    for (const JsonNode& each : node["levels"].items(0, kMostIsodoses))
        isodoses.levels.push_back(isodoseFrom(each));
    return isodoses;
}

}  // namespace macula::scene
