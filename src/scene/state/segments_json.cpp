#include "scene/state/segments_json.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "scene/state/json_names.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kDigestLength = 64;

bool isDigest(std::string_view text) {
    return text.size() == kDigestLength &&
           text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

double wholeNumber(const JsonNode& node, JsonRange range) {
    const double number = node.number(range);
    if (number != std::floor(number)) node.fail(Text("a whole number"));
    return std::floor(number);
}

std::array<std::uint8_t, 3> rgbFrom(const JsonNode& node) {
    std::array<std::uint8_t, 3> rgb{};
    const std::vector<JsonNode> items = node.items(3, 3);
    for (std::size_t i = 0; i < items.size(); ++i)
        rgb.at(i) = static_cast<std::uint8_t>(wholeNumber(items[i], {0.0, 255.0}));
    return rgb;
}

SegmentSettings segmentFrom(const JsonNode& node) {
    node.allowOnly({"number", "visible", "rgb", "opacity", "in3d", "colouredIn3d", "opacityIn3d"});
    SegmentSettings segment;
    segment.number = static_cast<std::uint16_t>(wholeNumber(node["number"], {0.0, double(kMostSegments)}));
    if (const auto visible = node.find("visible")) segment.isVisible = visible->boolean();
    if (const auto rgb = node.find("rgb")) segment.rgb = rgbFrom(*rgb);
    if (const auto opacity = node.find("opacity")) segment.opacity = opacity->number({0.0, 1.0});
    readName(node, "in3d", kIn3d, segment.in3d);
    if (const auto coloured = node.find("colouredIn3d")) segment.isColouredIn3d = coloured->boolean();
    if (const auto opacity = node.find("opacityIn3d")) segment.opacityIn3d = opacity->number({0.0, 1.0});
    return segment;
}

Json toJson(const SegmentSettings& segment) {
    const SegmentSettings usual;
    Json json{{"number", segment.number}};
    if (!segment.isVisible) json["visible"] = false;
    if (segment.rgb) json["rgb"] = *segment.rgb;
    if (segment.opacity != usual.opacity && segment.opacity >= 0.0 && segment.opacity <= 1.0)
        json["opacity"] = segment.opacity;
    if (segment.in3d != usual.in3d) json["in3d"] = nameOf(segment.in3d);
    if (segment.isColouredIn3d) json["colouredIn3d"] = true;
    if (segment.opacityIn3d != usual.opacityIn3d && segment.opacityIn3d >= 0.0 && segment.opacityIn3d <= 1.0)
        json["opacityIn3d"] = segment.opacityIn3d;
    return json;
}

}  // namespace

Json segmentationsJson(std::span<const SegmentationSettings> choices) {
    Json all = Json::array();
    for (const SegmentationSettings& choice : choices) {
        if (all.size() == kMostSegmentations) break;
        if (!isDigest(choice.digest)) continue;
        Json json{{"object", choice.digest}};
        if (choice.isShown) json["shown"] = true;
        for (const SegmentSettings& segment : choice.segments) {
            json["segments"].push_back(toJson(segment));
        }
        all.push_back(std::move(json));
    }
    return all;
}

std::vector<SegmentationSettings> segmentationsFrom(const JsonNode& node) {
    std::vector<SegmentationSettings> choices;
    for (const JsonNode& item : node.items(0, kMostSegmentations)) {
        item.allowOnly({"object", "shown", "segments"});
        SegmentationSettings choice;
        choice.digest = item["object"].text();
        if (!isDigest(choice.digest)) item["object"].fail(Text("64 hexadecimal digits"));
        if (const auto shown = item.find("shown")) choice.isShown = shown->boolean();
        if (const auto segments = item.find("segments")) {
            for (const JsonNode& segment : segments->items(0, kMostSegments))
                choice.segments.push_back(segmentFrom(segment));
        }
        choose(choices, std::move(choice));
    }
    return choices;
}

}  // namespace macula::scene
