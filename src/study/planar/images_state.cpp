#include "study/planar/images_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/utf8.h"

namespace macula::study {

namespace {

using Json = nlohmann::json;
using Kind = ImageMeasurement::Kind;

constexpr int kVersion = 1;
constexpr std::array kKinds{Kind::distance, Kind::angle, Kind::ellipse, Kind::cobb};
constexpr std::size_t kLongestLabel = 200;  // bytes of UTF-8
constexpr std::size_t kDigestDigits = 64;
constexpr double kFarthest = 1e6;
constexpr int kMostFrames = 10'000'000;

std::optional<double> numberOf(const Json& json, double most) {
    if (!json.is_number()) return {};
    const double value = json.get<double>();
    return std::isfinite(value) && std::abs(value) <= most ? std::optional(value) : std::nullopt;
}

std::optional<double> memberOf(const Json& json, const char* name, double most) {
    const auto found = json.find(name);
    return found == json.end() ? std::nullopt : numberOf(*found, most);
}

bool flagOf(const Json& json, const char* name, bool usual) {
    const auto found = json.find(name);
    return found != json.end() && found->is_boolean() ? found->get<bool>() : usual;
}

std::string textOf(const Json& json, const char* name) {
    const auto found = json.find(name);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<glm::dvec2> pointOf(const Json& json) {
    if (!json.is_array() || json.size() != 2) return {};
    const auto x = numberOf(json[0], kFarthest);
    const auto y = numberOf(json[1], kFarthest);
    if (!x || !y) return {};
    return glm::dvec2(*x, *y);
}

Json toJson(const ImageMeasurement& measurement) {
    Json points = Json::array();
    for (const glm::dvec2& p : measurement.points) points.push_back({p.x, p.y});
    return {{"kind", std::string(kindOf(measurement))},
            {"label", measurement.label},
            {"image", measurement.image},
            {"frame", measurement.frame},
            {"points", std::move(points)}};
}

std::optional<ImageMeasurement> measurementOf(const Json& json) {
    if (!json.is_object()) return {};
    ImageMeasurement measurement;
    const std::string kind = textOf(json, "kind");
    const auto* known = std::ranges::find_if(
        kKinds, [&](Kind each) { return kindOf(ImageMeasurement{.kind = each, .points = {}}) == kind; });
    if (known == kKinds.end()) return {};
    measurement.kind = *known;
    measurement.image = textOf(json, "image");
    const auto frame = memberOf(json, "frame", kMostFrames);
    const bool isImage = measurement.image.size() == kDigestDigits &&
                         measurement.image.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!isImage || !frame || *frame < 0.0) return {};
    measurement.frame = int(*frame);
    measurement.label = textOf(json, "label");
    measurement.label.resize(startOf(measurement.label, kLongestLabel).size());
    const auto points = json.find("points");
    if (points == json.end() || !points->is_array() || points->size() != pointsOf(measurement.kind))
        return {};
    for (const Json& each : *points) {
        const auto point = pointOf(each);
        if (!point) return {};
        measurement.points.push_back(*point);
    }
    return measurement;
}

std::optional<DisplayWindow> windowOf(const Json& json) {
    if (!json.is_object()) return {};
    constexpr double kMost = 1e12;
    const auto centre = memberOf(json, "center", kMost);
    const auto width = memberOf(json, "width", kMost);
    if (!centre || !width || !(*width > 0.0)) return {};
    const std::string function = textOf(json, "function");
    const bool isKnown =
        function.empty() || function == "LINEAR" || function == "LINEAR_EXACT" || function == "SIGMOID";
    if (!isKnown) return {};
    return DisplayWindow{.center = *centre, .width = *width, .explanation = {}, .function = function};
}

}  // namespace

std::string toJsonText(const ImagesState& state) {
    Json json{{"version", kVersion},
              {"measurements", Json::array()},
              {"place", state.place},
              {"inverted", state.isInverted},
              {"turned", state.quarters},
              {"mirrored", state.isMirrored},
              {"overlays", state.overlaysAreShown}};
    for (const ImageMeasurement& each : state.measurements) json["measurements"].push_back(toJson(each));
    if (state.window)
        json["window"] = {{"center", state.window->center},
                          {"width", state.window->width},
                          {"function", state.window->function}};
    if (state.scale) {
        json["scale"] = *state.scale;
        json["middle"] = {state.middlePx.x, state.middlePx.y};
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<ImagesState> imagesStateOf(std::string_view text) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || memberOf(json, "version", kVersion) != double{kVersion}) return {};
    ImagesState state;
    if (const auto list = json.find("measurements"); list != json.end() && list->is_array()) {
        for (const Json& each : *list) {
            if (state.measurements.size() == kMostImageMeasurements) break;
            if (auto measurement = measurementOf(each)) state.measurements.push_back(*std::move(measurement));
        }
    }
    if (const auto place = memberOf(json, "place", kMostFrames); place && *place >= 0.0)
        state.place = std::size_t(*place);
    if (const auto window = json.find("window"); window != json.end()) state.window = windowOf(*window);
    state.isInverted = flagOf(json, "inverted", false);
    if (const auto turned = memberOf(json, "turned", 3.0); turned && *turned >= 0.0)
        state.quarters = int(*turned);
    state.isMirrored = flagOf(json, "mirrored", false);
    state.overlaysAreShown = flagOf(json, "overlays", true);
    const auto middle = json.find("middle");
    const auto scale = memberOf(json, "scale", kFarthest);
    const auto place = middle == json.end() ? std::nullopt : pointOf(*middle);
    if (scale && *scale > 0.0 && place) {
        state.scale = scale;
        state.middlePx = *place;
    }
    return state;
}

}  // namespace macula::study
