// What the shapes of a clip share: their errors, and their points in JSON and in a volume.
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "base/is_finite.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/json_reader.h"

namespace macula {

inline Error clipNotUsable(const Text& what, Text hint) {
    return {ErrorCode::usage, Text("The clip is not usable: {}.", what), {}, std::move(hint)};
}

inline std::vector<double> numbersOf(std::initializer_list<glm::dvec3> vectors) {
    std::vector<double> numbers;
    for (const glm::dvec3& v : vectors) numbers.insert(numbers.end(), {v.x, v.y, v.z});
    return numbers;
}

inline glm::dvec3 mmOfFraction(const glm::dvec3& fraction, const Box& volume) {
    return volume.low + fraction * (volume.high - volume.low);
}
inline glm::dvec3 fractionOfMm(const glm::dvec3& mm, const Box& volume) {
    return (mm - volume.low) / (volume.high - volume.low);
}

inline glm::dvec3 pointOf(const JsonNode& node) {
    const std::vector<double> p = node.numbers(3, {-10.0, 10.0});
    return {p[0], p[1], p[2]};
}
inline nlohmann::ordered_json listOf(const glm::dvec3& p) {
    return {p.x, p.y, p.z};
}

}  // namespace macula
