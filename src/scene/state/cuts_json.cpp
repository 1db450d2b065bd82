#include "scene/state/cuts_json.h"

#include <cmath>
#include <utility>

#include "base/utf8.h"
#include "pipeline/volume/json_reader.h"
#include "scene/camera/camera_file.h"
#include "scene/clip/scissor_cut.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr JsonRange kAnyMm{-1e6, 1e6};
constexpr JsonRange kHalfHeights{-1e6, 1e6};
constexpr double kRounding = 1e-12;  // the error in the length of a unit vector in double precision

EyeCut eyeFrom(const JsonNode& node) {
    node.allowOnly({"normal", "offsetMm", "fromMiddleMm", "followsCamera"});
    EyeCut cut;
    const std::vector<double> xyz = node["normal"].numbers(3, kAnyMm);
    const glm::dvec3 normal(xyz[0], xyz[1], xyz[2]);
    const double length = glm::length(normal);
    if (length > 1e-6) {
        cut.plane.normal = std::abs(length - 1.0) < kRounding ? normal : normal / length;
    } else {
        node["normal"].fail(Text("a direction, not all zeros"));
    }
    cut.plane.offsetMm = node["offsetMm"].number(kAnyMm);
    if (const auto depth = node.find("fromMiddleMm")) cut.fromMiddleMm = depth->number(kAnyMm);
    cut.followsCamera = false;
    if (const auto follows = node.find("followsCamera")) cut.followsCamera = follows->boolean();
    return cut;
}

ScissorCut scissorFrom(const JsonNode& node) {
    node.allowOnly({"camera", "outline", "removes"});
    ScissorCut cut;
    cut.camera = cameraFrom(node["camera"]);
    const JsonNode outline = node["outline"];
    const std::vector<JsonNode> numbers = outline.items(6, 2 * kMostOutlinePoints);
    if (numbers.size() % 2 != 0) outline.fail(Text("pairs of numbers"));
    std::vector<glm::dvec2> points;
    for (std::size_t i = 1; i < numbers.size(); i += 2)
        points.emplace_back(numbers[i - 1].number(kHalfHeights), numbers[i].number(kHalfHeights));
    cut.outline = std::move(points);
    if (const auto removes = node.find("removes")) {
        const std::string text = removes->text();
        if (text != "inside" && text != "outside") removes->fail(Text("\"inside\" or \"outside\""));
        cut.removesOutside = text == "outside";
    }
    if (!validate(cut)) node.fail(Text("a camera, and an outline that encloses something"));
    return cut;
}

Json eyeJson(const EyeCut& cut) {
    return {{"normal", {cut.plane.normal.x, cut.plane.normal.y, cut.plane.normal.z}},
            {"offsetMm", cut.plane.offsetMm},
            {"fromMiddleMm", cut.fromMiddleMm},
            {"followsCamera", cut.followsCamera}};
}

Json scissorJson(const ScissorCut& cut) {
    Json outline = Json::array();
    for (const glm::dvec2& p : cut.outline) {
        outline.push_back(p.x);
        outline.push_back(p.y);
    }
    Json json{{"camera", toJson(cut.camera)}, {"outline", std::move(outline)}};
    if (cut.removesOutside) json["removes"] = "outside";
    return json;
}

template <class From>
bool isTaken(const Json& json, const From& from) {
    const JsonDocument document = JsonDocument::of(nlohmann::json(json), {});
    from(document.root());
    return document.status().ok();
}

// The name as it will be read: writing JSON replaces bytes that are not UTF-8.
std::string writtenName(const std::string& name) {
    const std::string text =
        Json::parse(Json(name).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
    return std::string(startOf(text, kLongestClipNameBytes));
}

// The reader of clip presets reads its clip.
Result<NamedClip> namedClipFrom(const Json& json, const std::string& where) {
    const JsonDocument document = JsonDocument::of(nlohmann::json(json), where);
    const JsonNode root = document.root();
    root.allowOnly({"name", "clip", "cuts"});
    NamedClip named{.name = root["name"].text()};
    if (named.name.empty() || named.name.size() > kLongestClipNameBytes)
        root["name"].fail(Text("1 to {} bytes", kLongestClipNameBytes));
    if (const auto cuts = root.find("cuts")) named.cuts = cutsFrom(*cuts);
    MACULA_TRY_VOID(document.status());
    if (json.contains("clip")) {
        MACULA_TRY(named.clip, clipPresetFromJson(json["clip"].dump(), where));
    }
    return named;
}

}  // namespace

Json toJson(const Cuts& cuts) {
    Json json = Json::object();
    if (cuts.eye) {
        Json eye = eyeJson(*cuts.eye);
        if (isTaken(eye, eyeFrom)) json["eye"] = std::move(eye);
    }
    for (const ScissorCut& cut : cuts.scissors) {
        if (json.contains("scissors") && json["scissors"].size() == kMostScissorCuts) break;
        Json scissor = scissorJson(cut);
        if (isTaken(scissor, scissorFrom)) json["scissors"].push_back(std::move(scissor));
    }
    return json;
}

Json namedClipsJson(const std::vector<NamedClip>& clips) {
    Json all = Json::array();
    for (const NamedClip& named : clips) {
        if (all.size() == kMostNamedClips) break;
        Json json{{"name", writtenName(named.name)}};
        if (named.clip) json["clip"] = Json::parse(toJson(*named.clip));
        if (Json cuts = toJson(named.cuts); !cuts.empty()) json["cuts"] = std::move(cuts);
        if (namedClipFrom(json, {})) all.push_back(std::move(json));
    }
    return all;
}

Cuts cutsFrom(const JsonNode& node) {
    node.allowOnly({"eye", "scissors"});
    Cuts cuts;
    if (const auto eye = node.find("eye")) cuts.eye = eyeFrom(*eye);
    if (const auto scissors = node.find("scissors")) {
        for (const JsonNode& cut : scissors->items(0, kMostScissorCuts))
            cuts.scissors.push_back(scissorFrom(cut));
    }
    return cuts;
}

Result<std::vector<NamedClip>> namedClipsFrom(const Json& all, const std::string& where) {
    if (!all.is_array() || all.size() > kMostNamedClips)
        return Error{ErrorCode::inputNotUsable, Text("namedClips: expected another thing."), where,
                     Text("A list of at most {} clips.", kMostNamedClips)};
    std::vector<NamedClip> clips;
    for (const Json& json : all) {
        MACULA_TRY(NamedClip named, namedClipFrom(json, where));
        clips.push_back(std::move(named));
    }
    return clips;
}

}  // namespace macula::scene
