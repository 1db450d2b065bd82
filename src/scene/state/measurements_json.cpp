#include "scene/state/measurements_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/utf8.h"
#include "pipeline/volume/json_reader.h"
#include "scene/state/json_vectors.h"
#include "slices/outline.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;
using slices::Angle;
using slices::Arrow;
using slices::Bidirectional;
using slices::CobbAngle;
using slices::Distance;
using slices::Ellipse;
using slices::Measurement;
using slices::OpenLine;
using slices::Outline;
using Shape = decltype(Measurement::shape);

constexpr JsonRange kRadiusMm{0.0, 1e6};
constexpr double kPerpendicular = 1e-3;  // cosines up to this count as a right angle
constexpr const char* kFirst = "measurements";
constexpr const char* kFurther = "furtherMeasurements";
constexpr const char* kOrder = "measurementOrder";

bool isOfFirstKinds(const Measurement& measurement) {
    return std::holds_alternative<Distance>(measurement.shape) ||
           std::holds_alternative<Angle>(measurement.shape) ||
           std::holds_alternative<Ellipse>(measurement.shape);
}

Ellipse ellipseFrom(const JsonNode& node) {
    Ellipse ellipse;
    ellipse.plane.centreMm = vector(node["centreMm"]);
    glm::dvec3& right = ellipse.plane.right;
    glm::dvec3& down = ellipse.plane.down;
    right = direction(node["right"]);
    down = direction(node["down"]);
    const double cosine = glm::dot(right, down);
    if (!(std::abs(cosine) <= kPerpendicular))
        node["down"].fail(Text("a direction perpendicular to \"right\""));
    if (std::abs(cosine) > kUnitRounding) down = glm::normalize(down - cosine * right);
    const std::vector<double> radii = node["radiiMm"].numbers(2, kRadiusMm);
    ellipse.radiiMm = {radii[0], radii[1]};
    return ellipse;
}

std::vector<glm::dvec3> pointsFrom(const JsonNode& node, std::size_t fewest, std::size_t most) {
    std::vector<glm::dvec3> points;
    for (const JsonNode& item : node.items(fewest, most)) points.push_back(vector(item));
    points.resize(std::max(points.size(), fewest));  // after an error, for whoever takes them
    return points;
}

struct KindOfPoints {
    Shape shape;
    std::size_t fewest, most;
};

// Of the shapes that points alone define.
std::vector<KindOfPoints> kindsOfPoints() {
    return {{Distance{}, 2, 2},
            {Angle{}, 3, 3},
            {Bidirectional{}, 4, 4},
            {CobbAngle{}, 4, 4},
            {Arrow{}, 2, 2},
            {Outline{}, slices::kFewestOutlinePoints, kMostDrawnPoints},
            {OpenLine{}, 2, kMostDrawnPoints}};
}

void setPoints(Shape& shape, std::vector<glm::dvec3> p) {
    if (auto* distance = std::get_if<Distance>(&shape)) distance->endsMm = {p[0], p[1]};
    if (auto* angle = std::get_if<Angle>(&shape)) angle->pointsMm = {p[0], p[1], p[2]};
    if (auto* cobb = std::get_if<CobbAngle>(&shape)) cobb->pointsMm = {p[0], p[1], p[2], p[3]};
    if (auto* arrow = std::get_if<Arrow>(&shape)) *arrow = {p[0], p[1]};
    if (auto* lesion = std::get_if<Bidirectional>(&shape)) {
        lesion->firstMm = {p[0], p[1]};
        lesion->secondMm = {p[2], p[3]};
    }
    if (auto* outline = std::get_if<Outline>(&shape))
        outline->pointsMm = std::move(p);
    else if (auto* line = std::get_if<OpenLine>(&shape))
        line->pointsMm = std::move(p);
}

Shape shapeFrom(const JsonNode& node) {
    const JsonNode kind = node["kind"];
    const std::string name = kind.text();
    if (name == slices::kindOf({.shape = Ellipse{}})) {
        node.allowOnly({"kind", "label", "centreMm", "right", "down", "radiiMm", "normal"});
        return ellipseFrom(node);
    }
    for (KindOfPoints& each : kindsOfPoints()) {
        if (name != slices::kindOf({.shape = each.shape})) continue;
        setPoints(each.shape, pointsFrom(node["pointsMm"], each.fewest, each.most));
        auto* lesion = std::get_if<Bidirectional>(&each.shape);
        if (lesion == nullptr) {
            node.allowOnly({"kind", "label", "pointsMm", "normal"});
        } else {
            node.allowOnly({"kind", "label", "node", "pointsMm", "normal"});
            if (const auto isNode = node.find("node")) lesion->isNode = isNode->boolean();
        }
        return each.shape;
    }
    kind.fail(Text(
        "\"distance\", \"angle\", \"ellipse\", \"bidirectional\", \"cobb angle\", \"arrow\", \"outline\" or "
        "\"line\""));
    return {};
}

Measurement measurementFrom(const JsonNode& node) {
    Measurement measurement{.shape = shapeFrom(node)};
    if (const auto label = node.find("label")) {
        measurement.label = label->text();
        if (measurement.label.size() > kLongestLabelBytes)
            label->fail(Text("at most {} bytes", kLongestLabelBytes));
    }
    measurement.normal = direction(node["normal"]);
    return measurement;
}

// The label as it will be read: writing JSON replaces bytes that are not UTF-8.
std::string writtenLabel(const std::string& label) {
    const std::string text =
        Json::parse(Json(label).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
    return std::string(startOf(text, kLongestLabelBytes));
}

// The measurements in that order, if it names each of them once.
std::vector<Measurement> ordered(std::vector<Measurement> all, const std::vector<std::size_t>& order) {
    if (order.size() != all.size()) return all;
    std::vector<bool> isNamed(all.size(), false);
    std::vector<Measurement> sorted;
    for (const std::size_t place : order) {
        if (place >= all.size() || isNamed[place]) return all;
        isNamed[place] = true;
        sorted.push_back(all[place]);
    }
    return sorted;
}

}  // namespace

Json toJson(const Measurement& measurement) {
    Json json{{"kind", slices::kindOf(measurement)}};
    if (!measurement.label.empty()) json["label"] = measurement.label;
    if (const auto* ellipse = std::get_if<Ellipse>(&measurement.shape)) {
        json["centreMm"] = list(ellipse->plane.centreMm);
        json["right"] = list(ellipse->plane.right);
        json["down"] = list(ellipse->plane.down);
        json["radiiMm"] = {ellipse->radiiMm.x, ellipse->radiiMm.y};
    } else {
        const auto* lesion = std::get_if<Bidirectional>(&measurement.shape);
        if (lesion != nullptr && lesion->isNode) json["node"] = true;
        json["pointsMm"] = Json::array();
        for (const glm::dvec3& mm : slices::pointsOf(measurement)) json["pointsMm"].push_back(list(mm));
    }
    json["normal"] = list(measurement.normal);
    return json;
}

void addMeasurements(std::span<const Measurement> measurements, Json& state) {
    Json first = Json::array();
    Json further = Json::array();
    std::vector<bool> isFirst;
    for (Measurement measurement : measurements) {
        if (isFirst.size() == kMostMeasurements) break;
        measurement.label = writtenLabel(measurement.label);
        Json json = toJson(measurement);
        if (!isTaken(json, measurementFrom)) continue;
        isFirst.push_back(isOfFirstKinds(measurement));
        (isFirst.back() ? first : further).push_back(std::move(json));
    }
    if (!std::ranges::is_sorted(isFirst, std::greater<>())) {
        std::size_t nextFirst = 0;
        std::size_t nextFurther = first.size();
        for (const bool isOfFirst : isFirst) state[kOrder].push_back(isOfFirst ? nextFirst++ : nextFurther++);
    }
    if (!first.empty()) state[kFirst] = std::move(first);
    if (!further.empty()) state[kFurther] = std::move(further);
}

std::vector<Measurement> measurementsFrom(const JsonNode& state) {
    std::vector<Measurement> measurements;
    for (const char* key : {kFirst, kFurther}) {
        const auto node = state.find(key);
        if (!node) continue;
        for (const JsonNode& item : node->items(0, kMostMeasurements - measurements.size()))
            measurements.push_back(measurementFrom(item));
    }
    std::vector<std::size_t> order;
    if (const auto node = state.find(kOrder))
        for (const JsonNode& item : node->items(0, kMostMeasurements))
            order.push_back(std::size_t(item.number({0.0, double(kMostMeasurements)})));
    return ordered(std::move(measurements), order);
}

}  // namespace macula::scene
