// What the shapes of a clip share: their errors, those that planes bound, and their points in JSON.
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

template <class Sides>
bool isInsideAll(const Sides& sides, const glm::dvec3& pointMm) {
    return std::ranges::all_of(sides, [&](const HalfSpace& side) { return side.contains(pointMm); });
}
// A convex region contains a box that has all corners in it.
template <class Sides>
bool areInsideAll(const Sides& sides, const BoxCorners& corners) {
    return std::ranges::all_of(corners, [&](const glm::dvec3& p) { return isInsideAll(sides, p); });
}
// It contains nothing of a box whose corners all lie beyond one of its sides.
template <class Sides>
bool areBeyondOne(const Sides& sides, const BoxCorners& corners) {
    return std::ranges::any_of(sides, [&](const HalfSpace& side) { return side.containsNone(corners); });
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
