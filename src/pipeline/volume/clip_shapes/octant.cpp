// A corner: one of the eight octants around a point.
#include <string>

#include "pipeline/volume/clip_shape_parts.h"

namespace macula {

std::array<HalfSpace, 3> sidesOf(const Octant& octant) {
    std::array<HalfSpace, 3> sides;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = octant.towards[axis];
        sides[std::size_t(axis)] = {normal, glm::dot(normal, octant.pointMm)};
    }
    return sides;
}

std::vector<double> Octant::numbers() const {
    return numbersOf({pointMm, towards});
}

Result<void> Octant::check() const {
    if (!isFinite(pointMm) || glm::abs(towards) != glm::dvec3(1.0))
        return clipNotUsable(Text("the corner has no direction"), Text("Give three signs, such as L, A, S."));
    return {};
}

void Octant::toMm(const Box& volume) {
    pointMm = mmOfFraction(pointMm, volume);
}

void Octant::toFractions(const Box& volume) {
    pointMm = fractionOfMm(pointMm, volume);
}

Octant Octant::read(const JsonNode& node) {
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
    return {.pointMm = pointOf(node["at"]),
            .towards = {sign(0, 'L', 'R'), sign(1, 'P', 'A'), sign(2, 'S', 'I')}};
}

nlohmann::ordered_json Octant::json() const {
    const auto letter = [](double sign, char positive, char negative) {
        return std::string(1, sign > 0.0 ? positive : negative);
    };
    return {
        {"at", listOf(pointMm)},
        {"towards", letter(towards.x, 'L', 'R') + letter(towards.y, 'P', 'A') + letter(towards.z, 'S', 'I')}};
}

}  // namespace macula
