#include "pipeline/trace/light_rig_json.h"

#include <nlohmann/json.hpp>

#include "pipeline/volume/json_reader.h"
#include "pipeline/volume/json_writer.h"

namespace macula::trace {

namespace {

constexpr JsonRange kRadiance{0.0, kMostRadiance};

glm::dvec3 radiance(const JsonNode& node) {
    const std::vector<double> rgb = node.numbers(3, kRadiance);
    return {rgb[0], rgb[1], rgb[2]};
}

LightFrame frame(const JsonNode& node) {
    const std::string text = node.text();
    if (text != "patient" && text != "camera") node.fail(Text("\"patient\" or \"camera\""));
    return text == "camera" ? LightFrame::camera : LightFrame::patient;
}

}  // namespace

Result<LightRig> lightRigFromJson(std::string_view text, const std::string& where) {
    const JsonDocument document(text, where);
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    root.allowOnly({"version", "name", "title", "frame", "ambient", "lights"});
    if (root["version"].number() != 1.0)
        root["version"].fail(Text("version 1; newer ones need a newer Macula"));

    LightRig rig;
    rig.name = root["name"].text();
    rig.title = root["title"].text();
    rig.frame = frame(root["frame"]);
    const JsonNode ambient = root["ambient"];
    ambient.allowOnly({"zenith", "horizon", "nadir"});
    rig.ambientZenith = radiance(ambient["zenith"]);
    rig.ambientHorizon = radiance(ambient["horizon"]);
    rig.ambientNadir = radiance(ambient["nadir"]);
    bool dark = rig.ambientZenith + rig.ambientHorizon + rig.ambientNadir == glm::dvec3(0.0);
    for (const JsonNode& node : root["lights"].items(0, kMostLights)) {
        node.allowOnly({"azimuthDeg", "elevationDeg", "angularRadiusDeg", "color", "radiance"});
        const SoftLight light{node["azimuthDeg"].number({-360.0, 360.0}),
                              node["elevationDeg"].number({-90.0, 90.0}),
                              node["angularRadiusDeg"].number({kLeastLightRadiusDeg, kMostLightRadiusDeg}),
                              radiance(node["color"]), node["radiance"].number(kRadiance)};
        dark = dark && light.colour * light.radiance == glm::dvec3(0.0);
        rig.lights.push_back(light);
    }
    if (dark) root.fail(Text("a light or an ambient sky that is not black"));
    MACULA_TRY_VOID(document.status());
    return rig;
}

std::string toJson(const LightRig& rig) {
    using Json = nlohmann::ordered_json;
    const auto rgb = [](const glm::dvec3& colour) { return Json{colour.x, colour.y, colour.z}; };
    Json lights = Json::array();
    for (const SoftLight& light : rig.lights) {
        lights.push_back({{"azimuthDeg", light.azimuthDeg},
                          {"elevationDeg", light.elevationDeg},
                          {"angularRadiusDeg", light.angularRadiusDeg},
                          {"color", rgb(light.colour)},
                          {"radiance", light.radiance}});
    }
    return prettyJson({{"version", 1},
                       {"name", rig.name},
                       {"title", rig.title},
                       {"frame", rig.frame == LightFrame::camera ? "camera" : "patient"},
                       {"ambient",
                        {{"zenith", rgb(rig.ambientZenith)},
                         {"horizon", rgb(rig.ambientHorizon)},
                         {"nadir", rgb(rig.ambientNadir)}}},
                       {"lights", std::move(lights)}});
}

}  // namespace macula::trace
