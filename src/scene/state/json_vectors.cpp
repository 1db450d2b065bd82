#include "scene/state/json_vectors.h"

#include <cmath>
#include <vector>

namespace macula::scene {

namespace {

constexpr JsonRange kAnyMm{-1e6, 1e6};

}  // namespace

nlohmann::ordered_json list(const glm::dvec3& v) {
    return nlohmann::ordered_json{v.x, v.y, v.z};
}

glm::dvec3 vector(const JsonNode& node) {
    const std::vector<double> xyz = node.numbers(3, kAnyMm);
    return {xyz[0], xyz[1], xyz[2]};
}

glm::dvec3 direction(const JsonNode& node) {
    const glm::dvec3 v = vector(node);
    const double length = glm::length(v);
    if (!(length > 1e-6)) {
        node.fail(Text("a direction, not all zeros"));
        return {0.0, 0.0, 1.0};
    }
    return std::abs(length - 1.0) < kUnitRounding ? v : v / length;
}

}  // namespace macula::scene
