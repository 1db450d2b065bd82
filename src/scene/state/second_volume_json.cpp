#include "scene/state/second_volume_json.h"

#include <cmath>
#include <vector>

#include "pipeline/volume/json_reader.h"
#include "pipeline/volume/transfer_function_json.h"
#include "registration/rigid_registration.h"
#include "scene/state/isodoses_json.h"
#include "scene/state/json_names.h"
#include "scene/state/slices_json.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr JsonRange kOfTransform{-1e6, 1e6};
constexpr JsonRange kBoundMm{0.0, 1e6};
constexpr std::size_t kLongestVolumeKey = 80;
constexpr JsonRange kPlaces{1.0, 1e9};  // the number of a volume among those of its series

glm::dmat4 transformFrom(const JsonNode& node) {
    const std::vector<double> rows = node.numbers(16, kOfTransform);
    glm::dmat4 transform(1.0);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            transform[column][row] = rows[4 * std::size_t(row) + std::size_t(column)];
    if (registration::isRigid(transform)) return transform;
    node.fail(Text("a rotation and a shift, row by row"));
    return glm::dmat4(1.0);
}

}  // namespace

Json toJson(const SecondVolumeState& state) {
    Json json{{"series", state.seriesDigest}};
    if (state.volume) json["volume"] = *state.volume + 1;
    if (!state.volumeKey.empty()) json["volumeKey"] = state.volumeKey;
    if (!state.pair.empty()) json["pair"] = state.pair;
    json["link"] = nameOf(state.link);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            json["secondFromStudy"].push_back(state.secondFromStudy[column][row]);
    if (state.link == SecondVolumeLink::registered) {
        json["boundMm"] = state.boundMm;
        if (state.isDoubtful) json["doubtful"] = true;
        if (state.rivalMm > 0.0) json["rivalMm"] = state.rivalMm;
    }
    json["view"] = nameOf(state.view);
    if (state.window) {
        if (Json window = windowJson(*state.window); !window.is_null()) json["window"] = std::move(window);
    }
    if (state.linksWindow) json["linksWindow"] = true;
    json["opacity"] = state.opacity;
    json["colours"] = slices::nameOf(state.colours);
    if (state.in3d) json["in3d"] = true;
    if (state.preset) json["preset"] = Json::parse(toJson(*state.preset));
    if (state.isodoses) json["isodoses"] = toJson(*state.isodoses);
    const JsonDocument document = JsonDocument::of(nlohmann::json(json), {});
    secondVolumeStateFrom(document.root());
    return document.status().ok() ? json : Json();
}

SecondVolumeState secondVolumeStateFrom(const JsonNode& node) {
    node.allowOnly({"series", "volume", "volumeKey", "pair", "link", "secondFromStudy", "boundMm", "doubtful",
                    "rivalMm", "view", "window", "linksWindow", "opacity", "colours", "in3d", "preset",
                    "isodoses"});
    SecondVolumeState state;
    state.seriesDigest = node["series"].text();
    if (state.seriesDigest.empty()) node["series"].fail(Text("the digest of a series"));
    if (const auto volume = node.find("volume")) {
        const double place = volume->number(kPlaces);
        if (place != std::floor(place)) volume->fail(Text("a whole number"));
        state.volume = std::size_t(place) - 1;
    }
    if (const auto key = node.find("volumeKey")) {
        state.volumeKey = key->text();
        if (state.volumeKey.size() > kLongestVolumeKey) key->fail(Text("the digest of a volume"));
    }
    if (const auto pair = node.find("pair")) {
        state.pair = pair->text();
        if (state.pair.size() > kLongestVolumeKey) pair->fail(Text("the digest of two volumes"));
    }
    readName(node, "link", kSecondVolumeLinks, state.link);
    if (const auto transform = node.find("secondFromStudy"))
        state.secondFromStudy = transformFrom(*transform);
    const auto bound = node.find("boundMm");
    const double boundMm = bound ? bound->number(kBoundMm) : 0.0;
    const auto doubtful = node.find("doubtful");
    const bool isDoubtful = doubtful && doubtful->boolean();
    const auto rival = node.find("rivalMm");
    const double rivalMm = rival ? rival->number(kBoundMm) : 0.0;
    // Other links have no registration that could be doubtful.
    if (state.link == SecondVolumeLink::registered) {
        state.boundMm = boundMm;
        state.isDoubtful = isDoubtful;
        state.rivalMm = rivalMm;
    }
    readName(node, "view", kSecondVolumePlaces, state.view);
    if (const auto window = node.find("window")) state.window = windowFrom(*window);
    if (const auto links = node.find("linksWindow")) state.linksWindow = links->boolean();
    if (const auto opacity = node.find("opacity")) state.opacity = opacity->number({0.0, 1.0});
    readName(node, "colours", slices::kColourTables, state.colours);
    if (const auto in3d = node.find("in3d")) state.in3d = in3d->boolean();
    if (const auto isodoses = node.find("isodoses")) state.isodoses = isodosesFrom(*isodoses);
    return state;
}

}  // namespace macula::scene
