#include "pipeline/volume/clip_json.h"

#include "pipeline/volume/clip_shape_parts.h"
#include "pipeline/volume/json_writer.h"
#include "pipeline/volume/window.h"

namespace macula {

namespace {

constexpr JsonRange kPositive{1e-9, 1e9};
constexpr std::string_view kPlanes = "planes";
using Json = nlohmann::ordered_json;

Keep keepOf(const JsonNode& node) {
    const std::string text = node.text();
    if (text != "inside" && text != "outside") node.fail(Text("\"inside\" or \"outside\""));
    return text == "outside" ? Keep::outside : Keep::inside;
}

// The keys of the shapes, in their order, between those before and after them.
std::vector<std::string_view> knownKeys() {
    std::vector<std::string_view> keys{"version", "name", "title"};
    const Clip any;
    forEachPart(any, [&](const auto& part, Keep) {
        if constexpr (requires { part.has_value(); }) {
            keys.push_back(std::remove_cvref_t<decltype(*part)>::kKey);
        } else {
            keys.push_back(kPlanes);
        }
    });
    keys.insert(keys.end(), {"removedCastsShadow", "greyFaces", "belowWindow"});
    return keys;
}

void readPlanes(ClipPreset& preset, const JsonNode& nodes) {
    for (const JsonNode& node : nodes.items(0, Clip::kMostPlanes)) {
        node.allowOnly({"normal", "at"});
        const glm::dvec3 normal = pointOf(node["normal"]);
        if (glm::length(normal) < 1e-6) node["normal"].fail(Text("a direction, not all zeros"));
        preset.clip.planes.push_back({glm::normalize(normal), 0.0});
        preset.planesAt.push_back(pointOf(node["at"]));
    }
}

void readShapes(ClipPreset& preset, const JsonNode& root) {
    forEachPart(preset.clip, [&](auto& part, auto&& keep) {
        if constexpr (requires { part.has_value(); }) {
            using Shape = std::remove_cvref_t<decltype(*part)>;
            const auto node = root.find(Shape::kKey);
            if (!node) return;
            part = Shape::read(*node);
            if constexpr (Shape::kHasKeep) keep = keepOf((*node)["keep"]);
        } else if (const auto nodes = root.find(kPlanes)) {
            readPlanes(preset, *nodes);
        }
    });
}

void writeShapes(Json& json, const ClipPreset& preset) {
    std::size_t planes = 0;
    forEachShape(preset.clip, [&](const ClipShape auto& shape, Keep keep) {
        using Shape = std::remove_cvref_t<decltype(shape)>;
        if constexpr (std::is_same_v<Shape, HalfSpace>) {
            json[kPlanes].push_back(
                {{"normal", listOf(shape.normal)}, {"at", listOf(preset.planesAt[planes++])}});
        } else {
            json[Shape::kKey] = shape.json();
            if (Shape::kHasKeep) json[Shape::kKey]["keep"] = keep == Keep::outside ? "outside" : "inside";
        }
    });
}

}  // namespace

Result<ClipPreset> clipPresetFromJson(std::string_view text, const std::string& where) {
    const JsonDocument document(text, where);
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    root.allowOnly(knownKeys());
    if (root["version"].number() != 1.0)
        root["version"].fail(Text("version 1; newer ones need a newer Macula"));

    ClipPreset preset{.name = root["name"].text(), .title = root["title"].text(), .clip = {}, .planesAt = {}};
    Clip& clip = preset.clip;
    readShapes(preset, root);
    if (const auto node = root.find("removedCastsShadow")) clip.removedCastsShadow = node->boolean();
    if (const auto node = root.find("greyFaces")) {
        preset.greyFacesOfSeries = node->isText();
        if (preset.greyFacesOfSeries) {
            if (node->text() != "series") node->fail(Text("\"series\", or center and width"));
        } else {
            node->allowOnly({"center", "width"});
            clip.greyFaces = DisplayWindow{.center = (*node)["center"].number({-1e9, 1e9}),
                                           .width = (*node)["width"].number(kPositive),
                                           .explanation = {},
                                           .function = "LINEAR_EXACT"};
        }
    }
    if (const auto node = root.find("belowWindow")) {
        if (!root.find("greyFaces")) node->fail(Text("greyFaces beside it"));
        if (node->text() != "clear" && node->text() != "black") node->fail(Text("\"clear\" or \"black\""));
        clip.facesBelowWindowAreBlack = node->text() == "black";
    }
    MACULA_TRY_VOID(document.status());
    return preset;
}

std::string toJson(const ClipPreset& preset) {
    const Clip& clip = preset.clip;
    Json json{{"version", 1}, {"name", preset.name}, {"title", preset.title}};
    writeShapes(json, preset);
    if (clip.removedCastsShadow) json["removedCastsShadow"] = true;
    if (preset.greyFacesOfSeries) {
        json["greyFaces"] = "series";
    } else if (clip.greyFaces) {
        json["greyFaces"] = {{"center", clip.greyFaces->center}, {"width", clip.greyFaces->width}};
    }
    if (clip.facesBelowWindowAreBlack) json["belowWindow"] = "black";
    return prettyJson(json);
}

Clip clipFor(const ClipPreset& preset, const Volume& volume) {
    const Box box = volume.worldBox();
    Clip clip = preset.clip;
    shapesToMm(clip, box);
    for (std::size_t i = 0; i < clip.planes.size(); ++i)
        clip.planes[i].offsetMm = glm::dot(clip.planes[i].normal, mmOfFraction(preset.planesAt[i], box));
    if (preset.greyFacesOfSeries) clip.greyFaces = seriesWindow(volume);
    return clip;
}

}  // namespace macula
