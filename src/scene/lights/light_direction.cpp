#include "scene/lights/light_direction.h"

#include <algorithm>
#include <cmath>

namespace macula::scene {

namespace {

constexpr double kHalfTurnDeg = 180.0;
constexpr double kRadius = 0.92;  // radius of the dome, in halves of the picture's shorter side

// The columns are the directions right, up and towards azimuth 0 of the rig, before the lights are turned.
glm::dmat3 worldFromRig(const LightStand& stand) {
    if (stand.frame == trace::LightFrame::camera) return {stand.eye.right, stand.eye.up, -stand.eye.forward};
    return {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, -1, 0)};  // Left, Superior, Anterior
}

glm::dvec2 placeFromHalfSides(const glm::dvec2& place, double aspect) {
    return aspect >= 1.0 ? glm::dvec2(place.x / aspect, place.y) : glm::dvec2(place.x, place.y * aspect);
}

glm::dvec2 halfSidesFromPlace(const glm::dvec2& place, double aspect) {
    return aspect >= 1.0 ? glm::dvec2(place.x * aspect, place.y) : glm::dvec2(place.x, place.y / aspect);
}

}  // namespace

glm::dvec3 directionTo(const trace::SoftLight& light, const LightStand& stand) {
    const double azimuth = glm::radians(light.azimuthDeg + stand.rotationDeg);
    const double elevation = glm::radians(light.elevationDeg);
    return glm::normalize(worldFromRig(stand) * glm::dvec3(std::sin(azimuth) * std::cos(elevation),
                                                           std::sin(elevation),
                                                           std::cos(azimuth) * std::cos(elevation)));
}

trace::SoftLight shiningFrom(trace::SoftLight light, const glm::dvec3& direction, const LightStand& stand) {
    const double length = glm::length(direction);
    if (!(length > 0.0) || !std::isfinite(length)) return light;
    const glm::dvec3 inRig = glm::transpose(worldFromRig(stand)) * (direction / length);
    light.elevationDeg = glm::degrees(std::asin(std::clamp(inRig.y, -1.0, 1.0)));
    // At a pole every azimuth gives the same direction: the light keeps its own.
    if (std::hypot(inRig.x, inRig.z) > 1e-9)
        light.azimuthDeg = std::remainder(glm::degrees(std::atan2(inRig.x, inRig.z)) - stand.rotationDeg,
                                          2.0 * kHalfTurnDeg);
    return light;
}

glm::dvec2 circleOnDome(double fromMiddleDeg, double aroundRad, double aspect) {
    const double radius = kRadius * fromMiddleDeg / kHalfTurnDeg;
    return placeFromHalfSides(radius * glm::dvec2(std::cos(aroundRad), std::sin(aroundRad)), aspect);
}

glm::dvec2 placeOnDome(const glm::dvec3& direction, const CameraBasis& eye, double aspect) {
    const glm::dvec3 unit = glm::normalize(direction);
    const glm::dvec2 across(glm::dot(unit, eye.right), glm::dot(unit, eye.up));
    const double fromMiddle = std::atan2(glm::length(across), -glm::dot(unit, eye.forward));
    return circleOnDome(glm::degrees(fromMiddle), std::atan2(across.y, across.x), aspect);
}

glm::dvec3 directionOnDome(const glm::dvec2& place, const CameraBasis& eye, double aspect) {
    const glm::dvec2 across = halfSidesFromPlace(place, aspect);
    const double radius = glm::length(across);
    if (!(radius > 0.0)) return -eye.forward;
    const double fromMiddle = glm::radians(kHalfTurnDeg * std::min(radius / kRadius, 1.0));
    const glm::dvec2 unit = across / radius;
    return std::sin(fromMiddle) * (unit.x * eye.right + unit.y * eye.up) - std::cos(fromMiddle) * eye.forward;
}

}  // namespace macula::scene
