// StudyState as JSON:
//   { "version": 1, "series": "<SHA-256>",
//     "grid": { "size": [512, 512, 95], "worldFromVoxel": [16 numbers, row by row] },
//     "look": "dvr", "shading": true, "filter": "trilinear", "denoising": "denoised",
//     <a key for each row of parameters()>,
//     "preset": {as presets/transfer}, "clip": {as presets/clip}, "leavesTableOut": true,
//     "lights": {as presets/lights}, "windows": { "mip": { "center": 40, "width": 400 } },
//     "camera": {as camera_file.h}, "cubeAndScale": false, "background": "#rrggbb", "layout": "axial",
//     "slices": {as slices_json.h}, <keys of measurements_json.h>, "cuts": {as cuts_json.h},
//     "namedClips": [likewise], "segmentations": [as segments_json.h], "beside": {as second_volume_json.h} }
// Everything but the version may be left out.
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "pipeline/trace/light_rig_json.h"
#include "pipeline/volume/json_reader.h"
#include "pipeline/volume/json_writer.h"
#include "pipeline/volume/transfer_function_json.h"
#include "scene/camera/camera_file.h"
#include "scene/state/cuts_json.h"
#include "scene/state/json_names.h"
#include "scene/state/measurements_json.h"
#include "scene/state/second_volume_json.h"
#include "scene/state/segments_json.h"
#include "scene/state/slices_json.h"
#include "scene/state/study_state.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kVersion = 1.0;
constexpr std::array kDenoisings{trace::Denoising::off, trace::Denoising::little, trace::Denoising::on};

bool isKnown(const std::string& key) {
    const std::vector<std::string> keys = stateKeys();
    return std::ranges::find(keys, key) != keys.end();
}

void readParameters(const JsonNode& root, trace::Settings& settings) {
    for (const Parameter& p : parameters()) {
        const auto node = root.find(p.id);
        if (!node) continue;
        const double value = node->number({p.low, p.high});
        if (p.isWhole && value != std::floor(value)) node->fail(Text("a whole number"));
        p.set(settings, value);
    }
}

Json toJson(const SavedGrid& grid) {
    Json json{{"size", {grid.size.x, grid.size.y, grid.size.z}}};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            json["worldFromVoxel"].push_back(grid.worldFromVoxel[column][row]);
    return json;
}

SavedGrid savedGridFrom(const JsonNode& node) {
    node.allowOnly({"size", "worldFromVoxel"});
    SavedGrid grid;
    const std::vector<double> size = node["size"].numbers(3, JsonRange{1.0, 65536.0});
    for (int axis = 0; axis < 3; ++axis)
        grid.size[axis] = static_cast<int>(std::lround(size[std::size_t(axis)]));
    const std::vector<double> rows = node["worldFromVoxel"].numbers(16, JsonRange{-1e6, 1e6});
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            grid.worldFromVoxel[column][row] = rows[4 * std::size_t(row) + std::size_t(column)];
    return grid;
}

void readWindows(const JsonNode& root, StudyState& state) {
    const auto windows = root.find("windows");
    if (!windows) return;
    for (const trace::LookTraits& look : trace::kLooks) {
        const auto node = windows->find(look.name);
        if (!node) continue;
        node->allowOnly({"center", "width"});
        state.windows.at(std::size_t(look.look)) =
            DisplayWindow{.center = (*node)["center"].number({-1e9, 1e9}),
                          .width = (*node)["width"].number({1e-9, 1e9}),
                          .explanation = {},
                          .function = "LINEAR_EXACT"};
    }
}

// Reads an object within the text with the reader of its own format.
template <class T, class Read>
Result<std::optional<T>> readPart(const Json& all, const char* key, const Read& read) {
    if (!all.contains(key)) return std::optional<T>();
    MACULA_TRY(T part, read(all[key].dump()));
    return std::optional<T>(std::move(part));
}

}  // namespace

std::vector<std::string> stateKeys() {
    std::vector<std::string> keys{
        "version",         "series",        "grid",   "look",           "shading",      "filter",
        "denoising",       "preset",        "clip",   "leavesTableOut", "lights",       "windows",
        "camera",          "layout",        "slices", "measurements",   "cubeAndScale", "cuts",
        "namedClips",      "segmentations", "beside", "background",     "toneMap",      "furtherMeasurements",
        "measurementOrder"};
    for (const Parameter& parameter : parameters()) keys.emplace_back(parameter.id);
    return keys;
}

std::string toJson(const StudyState& state) {
    Json json{{"version", kVersion}};
    if (!state.seriesDigest.empty()) json["series"] = state.seriesDigest;
    if (state.grid) json["grid"] = toJson(*state.grid);
    json["look"] = nameOf(state.settings.look);
    json["shading"] = state.settings.shading == trace::Shading::headlight;
    json["filter"] = nameOf(state.settings.filter);
    json["denoising"] = nameOf(state.settings.denoising);
    json["toneMap"] = nameOf(state.settings.toneMap);
    for (const Parameter& p : parameters()) json[std::string(p.id)] = p.get(state.settings);
    if (state.preset) json["preset"] = Json::parse(toJson(*state.preset));
    if (state.clip) json["clip"] = Json::parse(toJson(*state.clip));
    if (state.leavesTableOut) json["leavesTableOut"] = true;
    if (state.lights) json["lights"] = Json::parse(toJson(*state.lights));
    for (const trace::LookTraits& look : trace::kLooks) {
        if (const auto& window = state.windows.at(std::size_t(look.look)))
            json["windows"][std::string(look.name)] = {{"center", window->center}, {"width", window->width}};
    }
    if (state.camera) json["camera"] = toJson(*state.camera);
    if (!state.showsMarks) json["cubeAndScale"] = false;
    if (state.background) json["background"] = hexOf(*state.background);
    if (state.layout != StudyState{}.layout) json["layout"] = nameOf(state.layout);
    if (Json slices = toJson(state.slices); !slices.empty()) json["slices"] = std::move(slices);
    addMeasurements(state.measurements, json);
    if (Json cuts = toJson(state.cuts); !cuts.empty()) json["cuts"] = std::move(cuts);
    if (Json named = namedClipsJson(state.namedClips); !named.empty()) json["namedClips"] = std::move(named);
    if (Json all = segmentationsJson(state.segmentations); !all.empty())
        json["segmentations"] = std::move(all);
    if (state.secondVolume) {
        if (Json beside = toJson(*state.secondVolume); !beside.is_null()) json["beside"] = std::move(beside);
    }
    if (!state.otherKeys.empty()) {
        const Json others = Json::parse(state.otherKeys);
        for (const auto& [key, value] : others.items()) json[key] = value;
    }
    return prettyJson(json);
}

Result<StudyState> studyStateFromJson(std::string_view text, const std::string& where) {
    const JsonDocument document(text, where);
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    StudyState state;
    if (root["version"].number() != kVersion)
        root["version"].fail(Text("version 1; newer ones need a newer Macula"));
    if (const auto node = root.find("series")) state.seriesDigest = node->text();
    if (const auto node = root.find("grid")) state.grid = savedGridFrom(*node);
    std::array<trace::Look, trace::kLooks.size()> looks{};
    std::ranges::transform(trace::kLooks, looks.begin(), &trace::LookTraits::look);
    readName(root, "look", looks, state.settings.look);
    readName(root, "filter", trace::kFilters, state.settings.filter);
    readName(root, "denoising", kDenoisings, state.settings.denoising);
    readName(root, "toneMap", trace::kToneMaps, state.settings.toneMap);
    if (const auto node = root.find("shading"))
        state.settings.shading = node->boolean() ? trace::Shading::headlight : trace::Shading::none;
    readParameters(root, state.settings);
    if (const auto node = root.find("leavesTableOut")) state.leavesTableOut = node->boolean();
    readWindows(root, state);
    if (const auto node = root.find("camera")) {
        state.camera = cameraFrom(*node);
        if (!basis(*state.camera)) node->fail(Text("an eye, a target and an upright that make a camera"));
    }
    if (const auto node = root.find("cubeAndScale")) state.showsMarks = node->boolean();
    if (const auto node = root.find("background")) {
        state.background = colourOfHex(node->text());
        if (!state.background) node->fail(Text("a colour as #rrggbb"));
    }
    readName(root, "layout", kLayouts, state.layout);
    if (const auto node = root.find("slices")) state.slices = sliceStateFrom(*node);
    state.measurements = measurementsFrom(root);
    if (const auto node = root.find("cuts")) state.cuts = cutsFrom(*node);
    if (const auto node = root.find("segmentations")) state.segmentations = segmentationsFrom(*node);
    if (const auto node = root.find("beside")) state.secondVolume = secondVolumeStateFrom(*node);
    MACULA_TRY_VOID(document.status());

    // The text is valid JSON by now, and an object.
    const Json all = Json::parse(text);
    MACULA_TRY(const auto preset, readPart<TransferFunction>(all, "preset", [&](const std::string& part) {
                   return transferFunctionFromJson(part, where);
               }));
    if (preset) state.preset = std::make_shared<const TransferFunction>(*preset);
    if (state.secondVolume) {
        MACULA_TRY(const auto second,
                   readPart<TransferFunction>(all["beside"], "preset", [&](const std::string& part) {
                       return transferFunctionFromJson(part, where);
                   }));
        if (second) state.secondVolume->preset = std::make_shared<const TransferFunction>(*second);
    }
    MACULA_TRY(state.clip, readPart<ClipPreset>(all, "clip", [&](const std::string& part) {
                   return clipPresetFromJson(part, where);
               }));
    MACULA_TRY(const auto lights, readPart<trace::LightRig>(all, "lights", [&](const std::string& part) {
                   return trace::lightRigFromJson(part, where);
               }));
    if (lights) state.lights = std::make_shared<const trace::LightRig>(*lights);
    if (all.contains("namedClips")) {
        MACULA_TRY(state.namedClips, namedClipsFrom(all["namedClips"], where));
    }
    Json others = Json::object();
    for (const auto& [key, value] : all.items()) {
        if (!isKnown(key)) others[key] = value;
    }
    if (!others.empty()) state.otherKeys = others.dump();
    return state;
}

Result<StudyState> readStudyState(const std::filesystem::path& path) {
    MACULA_TRY(const std::string text, readText(path));
    return studyStateFromJson(text, path.string());
}

}  // namespace macula::scene
