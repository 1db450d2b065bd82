// A ball. In a preset its radius is a fraction of the shortest side of the volume's box.
#include "pipeline/volume/clip_shape_parts.h"

namespace macula {

namespace {

double shortestSideOf(const Box& box) {
    const glm::dvec3 size = box.high - box.low;
    return std::min({size.x, size.y, size.z});
}

}  // namespace

std::vector<double> Ball::numbers() const {
    return {centreMm.x, centreMm.y, centreMm.z, radiusMm};
}

Result<void> Ball::check() const {
    if (!isFinite(centreMm) || !std::isfinite(radiusMm) || radiusMm <= 0.0)
        return clipNotUsable(Text("the ball has no size"),
                             Text("Give a centre and a positive radius in mm."));
    return {};
}

bool contains(const Ball& ball, const glm::dvec3& pointMm) {
    return glm::length(pointMm - ball.centreMm) <= ball.radiusMm;
}

bool containsAll(const Ball& ball, const BoxCorners& corners) {
    return std::ranges::all_of(
        corners, [&](const glm::dvec3& p) { return glm::length(p - ball.centreMm) < ball.radiusMm; });
}

// No point of a box is nearer than its centre, minus half its diagonal.
bool containsNone(const Ball& ball, const BoxCorners& corners) {
    glm::dvec3 centre(0.0);
    for (const glm::dvec3& p : corners) centre += p / double(corners.size());
    double reach = 0.0;
    for (const glm::dvec3& p : corners) reach = std::max(reach, glm::length(p - centre));
    return glm::length(centre - ball.centreMm) - reach > ball.radiusMm;
}

void Ball::toMm(const Box& volume) {
    centreMm = mmOfFraction(centreMm, volume);
    radiusMm *= shortestSideOf(volume);
}

void Ball::toFractions(const Box& volume) {
    centreMm = fractionOfMm(centreMm, volume);
    radiusMm /= shortestSideOf(volume);
}

Ball Ball::read(const JsonNode& node) {
    node.allowOnly({"centre", "radius", "keep"});
    return {.centreMm = pointOf(node["centre"]), .radiusMm = node["radius"].number({1e-9, 10.0})};
}

nlohmann::ordered_json Ball::json() const {
    return {{"centre", listOf(centreMm)}, {"radius", radiusMm}};
}

}  // namespace macula
