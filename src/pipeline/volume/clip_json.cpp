#include "pipeline/volume/clip_json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "pipeline/volume/json_reader.h"
#include "pipeline/volume/json_writer.h"
#include "pipeline/volume/window.h"

namespace macula {

namespace {

constexpr JsonRange kFraction{-10.0, 10.0};
constexpr JsonRange kPositive{1e-9, 1e9};
using Json = nlohmann::ordered_json;

glm::dvec3 point(const JsonNode& node) {
    const std::vector<double> p = node.numbers(3, kFraction);
    return {p[0], p[1], p[2]};
}

Keep keep(const JsonNode& node) {
    const std::string text = node.text();
    if (text != "inside" && text != "outside") node.fail(Text("\"inside\" or \"outside\""));
    return text == "outside" ? Keep::outside : Keep::inside;
}

struct Ends {
    glm::dvec3 low;
    glm::dvec3 high;
};

// Finds ends from which `box` below makes the same box bit for bit, if there are any, because sums round.
Ends endsOf(const OrientedBox& box) {
    Ends ends{box.centreMm - box.halfSizeMm, box.centreMm + box.halfSizeMm};
    const auto isSame = [&](int axis, double low, double high) {
        return 0.5 * (low + high) == box.centreMm[axis] && 0.5 * (high - low) == box.halfSizeMm[axis];
    };
    constexpr double kFar = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double low = ends.low[axis];
        const double high = ends.high[axis];
        for (const double l : {low, std::nextafter(low, -kFar), std::nextafter(low, kFar)}) {
            for (const double h : {high, std::nextafter(high, -kFar), std::nextafter(high, kFar)}) {
                if (!isSame(axis, l, h)) continue;
                ends.low[axis] = l;
                ends.high[axis] = h;
            }
        }
    }
    return ends;
}

OrientedBox box(const JsonNode& node) {
    node.allowOnly({"low", "high", "keep"});
    const glm::dvec3 low = point(node["low"]);
    const glm::dvec3 high = point(node["high"]);
    if (!glm::all(glm::lessThan(low, high))) node.fail(Text("\"low\" below \"high\" on each axis"));
    return {.centreMm = 0.5 * (low + high), .halfSizeMm = 0.5 * (high - low)};
}

Octant octant(const JsonNode& node) {
    node.allowOnly({"at", "towards"});
    const JsonNode letters = node["towards"];
    const std::string text = letters.text();
    const auto sign = [&](std::size_t axis, char positive, char negative) {
        const char letter = axis < text.size() ? text[axis] : ' ';
        if (letter != positive && letter != negative)
            letters.fail(Text("L or R, then A or P, then S or I, such as \"LAS\""));
        return letter == negative ? -1.0 : 1.0;
    };
    if (text.size() != 3) letters.fail(Text("three letters, such as \"LAS\""));
    return {.pointMm = point(node["at"]),
            .towards = {sign(0, 'L', 'R'), sign(1, 'P', 'A'), sign(2, 'S', 'I')}};
}

}  // namespace

Result<ClipPreset> clipPresetFromJson(std::string_view text, const std::string& where) {
    const JsonDocument document(text, where);
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    root.allowOnly({"version", "name", "title", "box", "planes", "cut", "ball", "removedCastsShadow",
                    "greyFaces", "belowWindow"});
    if (root["version"].number() != 1.0)
        root["version"].fail(Text("version 1; newer ones need a newer Macula"));

    ClipPreset preset{.name = root["name"].text(), .title = root["title"].text(), .clip = {}, .planesAt = {}};
    Clip& clip = preset.clip;
    if (const auto node = root.find("box")) {
        clip.box = box(*node);
        clip.ofBox = keep((*node)["keep"]);
    }
    if (const auto nodes = root.find("planes")) {
        for (const JsonNode& node : nodes->items(0, Clip::kMostPlanes)) {
            node.allowOnly({"normal", "at"});
            const glm::dvec3 normal = point(node["normal"]);
            if (glm::length(normal) < 1e-6) node["normal"].fail(Text("a direction, not all zeros"));
            clip.planes.push_back({glm::normalize(normal), 0.0});
            preset.planesAt.push_back(point(node["at"]));
        }
    }
    if (const auto node = root.find("cut")) clip.cut = octant(*node);
    if (const auto node = root.find("ball")) {
        node->allowOnly({"centre", "radius", "keep"});
        clip.ball = Ball{point((*node)["centre"]), (*node)["radius"].number({1e-9, 10.0})};
        clip.ofBall = keep((*node)["keep"]);
    }
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
    const auto list = [](const glm::dvec3& p) { return Json{p.x, p.y, p.z}; };
    const auto name = [](Keep keep) { return keep == Keep::outside ? "outside" : "inside"; };
    const auto letter = [](double sign, char positive, char negative) {
        return std::string(1, sign > 0.0 ? positive : negative);
    };
    Json json{{"version", 1}, {"name", preset.name}, {"title", preset.title}};
    if (clip.box) {
        const auto [low, high] = endsOf(*clip.box);
        json["box"] = {{"low", list(low)}, {"high", list(high)}, {"keep", name(clip.ofBox)}};
    }
    for (std::size_t i = 0; i < clip.planes.size(); ++i)
        json["planes"].push_back({{"normal", list(clip.planes[i].normal)}, {"at", list(preset.planesAt[i])}});
    if (clip.cut) {
        const glm::dvec3& t = clip.cut->towards;
        json["cut"] = {{"at", list(clip.cut->pointMm)},
                       {"towards", letter(t.x, 'L', 'R') + letter(t.y, 'P', 'A') + letter(t.z, 'S', 'I')}};
    }
    if (clip.ball) {
        json["ball"] = {{"centre", list(clip.ball->centreMm)},
                        {"radius", clip.ball->radiusMm},
                        {"keep", name(clip.ofBall)}};
    }
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
    const glm::dvec3 size = box.high - box.low;
    const auto world = [&](const glm::dvec3& fraction) { return box.low + fraction * size; };
    Clip clip = preset.clip;
    if (clip.box) {
        clip.box->centreMm = world(clip.box->centreMm);
        clip.box->halfSizeMm *= size;
    }
    for (std::size_t i = 0; i < clip.planes.size(); ++i)
        clip.planes[i].offsetMm = glm::dot(clip.planes[i].normal, world(preset.planesAt[i]));
    if (clip.cut) clip.cut->pointMm = world(clip.cut->pointMm);
    if (clip.ball) {
        clip.ball->centreMm = world(clip.ball->centreMm);
        clip.ball->radiusMm *= std::min({size.x, size.y, size.z});
    }
    if (preset.greyFacesOfSeries) clip.greyFaces = seriesWindow(volume);
    return clip;
}

}  // namespace macula
