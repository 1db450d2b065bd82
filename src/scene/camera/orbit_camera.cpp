#include "scene/camera/orbit_camera.h"

#include <algorithm>
#include <cmath>

namespace macula::scene {

namespace {

constexpr double kDegreesPerPictureHeight = 180.0;
constexpr double kNearestOfDiagonal = 0.02;
constexpr double kFarthestOfDiagonal = 20.0;

// The direction from the patient's axis to the eye, within the axial plane.
glm::dvec3 horizontalDirection(double azimuthDeg) {
    const double azimuth = glm::radians(azimuthDeg);
    return {std::sin(azimuth), -std::cos(azimuth), 0.0};
}

struct Directions {
    glm::dvec3 eye;  // from the target
    glm::dvec3 up;
    glm::dvec3 right;
};

Directions directions(const OrbitCamera& camera) {
    const double elevation = glm::radians(camera.elevationDeg);
    const glm::dvec3 outward = horizontalDirection(camera.azimuthDeg);
    const glm::dvec3 superior{0.0, 0.0, 1.0};
    const glm::dvec3 eye = std::cos(elevation) * outward + std::sin(elevation) * superior;
    // The direction in which the eye moves when it rises. Unlike superior, it is never along the view.
    const glm::dvec3 upright = -std::sin(elevation) * outward + std::cos(elevation) * superior;
    const glm::dvec3 level = glm::cross(-eye, upright);
    if (camera.rollDeg == 0.0) return {eye, upright, level};
    // The camera rolls the opposite way from what it sees.
    const double roll = glm::radians(camera.rollDeg);
    return {eye, std::cos(roll) * upright - std::sin(roll) * level,
            std::cos(roll) * level + std::sin(roll) * upright};
}

double wrapped(double degrees) {
    return degrees - 360.0 * std::floor((degrees + 180.0) / 360.0);
}

}  // namespace

Camera toCamera(const OrbitCamera& orbit) {
    const Directions d = directions(orbit);
    Camera camera;
    camera.positionMm = orbit.targetMm + orbit.distanceMm * d.eye;
    camera.targetMm = orbit.targetMm;
    camera.up = d.up;
    camera.verticalFovDeg = orbit.verticalFovDeg;
    return orbit.isParallel ? inParallel(camera) : camera;
}

OrbitCamera orbitCameraOf(const Camera& camera) {
    const Camera near = inPerspective(camera);
    const glm::dvec3 toEye = near.positionMm - near.targetMm;
    const double distanceMm = glm::length(toEye);
    const glm::dvec3 eye = toEye / distanceMm;
    // From straight above or below, the up direction of the picture gives the azimuth.
    constexpr double kAtThePole = 1e-9;
    glm::dvec3 outward = eye;
    if (std::hypot(eye.x, eye.y) < kAtThePole) outward = eye.z > 0.0 ? -camera.up : camera.up;
    OrbitCamera orbit{.targetMm = camera.targetMm,
                      .distanceMm = distanceMm,
                      .azimuthDeg = wrapped(glm::degrees(std::atan2(outward.x, -outward.y))),
                      .elevationDeg = glm::degrees(std::asin(std::clamp(eye.z, -1.0, 1.0))),
                      .verticalFovDeg = camera.verticalFovDeg,
                      .isParallel = isParallel(camera)};
    const Directions upright = directions(orbit);
    const double roll = std::atan2(-glm::dot(camera.up, upright.right), glm::dot(camera.up, upright.up));
    constexpr double kRoundingDeg = 1e-6;
    if (std::abs(glm::degrees(roll)) > kRoundingDeg) orbit.rollDeg = wrapped(glm::degrees(roll));
    return orbit;
}

OrbitCamera fitted(OrbitCamera camera, std::span<const glm::dvec3> pointsMm, double aspectWidthOverHeight) {
    const Directions d = directions(camera);
    const CameraBasis axes{.right = d.right, .up = d.up, .forward = -d.eye};
    const auto frame = camera.isParallel ? frameInParallel : framePoints;
    const Camera straight =
        inPerspective(frame(pointsMm, axes, camera.verticalFovDeg, aspectWidthOverHeight));
    camera.targetMm = straight.targetMm;
    camera.distanceMm = glm::distance(straight.positionMm, straight.targetMm);
    return camera;
}

OrbitCamera turnedTo(OrbitCamera camera, ViewDirection from) {
    camera.azimuthDeg = camera.elevationDeg = camera.rollDeg = 0.0;
    switch (from) {
        case ViewDirection::anterior:
            break;
        case ViewDirection::posterior:
            camera.azimuthDeg = -180.0;
            break;
        case ViewDirection::left:
            camera.azimuthDeg = 90.0;
            break;
        case ViewDirection::right:
            camera.azimuthDeg = -90.0;
            break;
        case ViewDirection::superior:  // anterior is up in the picture: the eye rose behind the patient
            camera.azimuthDeg = -180.0;
            camera.elevationDeg = 90.0;
            break;
        case ViewDirection::inferior:
            camera.elevationDeg = -90.0;
            break;
        case ViewDirection::oblique:
        case ViewDirection::threeQuarter:
        case ViewDirection::turned:
            camera.azimuthDeg = obliquenessOf(from).azimuthDeg;
            camera.elevationDeg = obliquenessOf(from).elevationDeg;
            break;
    }
    return camera;
}

OrbitCamera framed(std::span<const glm::dvec3> pointsMm, ViewDirection from, double verticalFovDeg,
                   double aspectWidthOverHeight) {
    return fitted(turnedTo({.verticalFovDeg = verticalFovDeg}, from), pointsMm, aspectWidthOverHeight);
}

OrbitCamera orbited(OrbitCamera camera, double azimuthDeg, double elevationDeg) {
    camera.azimuthDeg = wrapped(camera.azimuthDeg + azimuthDeg);
    camera.elevationDeg = std::clamp(camera.elevationDeg + elevationDeg, -90.0, 90.0);
    return camera;
}

OrbitCamera orbitedByDrag(const OrbitCamera& camera, double dxPx, double dyPx, double heightPx) {
    const double degreesPerPixel = kDegreesPerPictureHeight / std::max(heightPx, 1.0);
    // The drag in the picture as it would be without roll.
    const double roll = glm::radians(camera.rollDeg);
    const double right = std::cos(roll) * dxPx + std::sin(roll) * dyPx;
    const double down = std::cos(roll) * dyPx - std::sin(roll) * dxPx;
    return orbited(camera, -right * degreesPerPixel, down * degreesPerPixel);
}

OrbitCamera rolled(OrbitCamera camera, double clockwiseDeg) {
    camera.rollDeg = wrapped(camera.rollDeg + clockwiseDeg);
    return camera;
}

OrbitCamera rolledByDrag(const OrbitCamera& camera, double dxPx, double heightPx) {
    return rolled(camera, dxPx * kDegreesPerPictureHeight / std::max(heightPx, 1.0));
}

OrbitCamera flown(OrbitCamera camera, double forwardMm, const Box& sceneMm) {
    const glm::dvec3 there = camera.targetMm - forwardMm * directions(camera).eye;
    const double beforeMm = glm::distance(camera.targetMm, sceneMm.centre());
    const double nowMm = glm::distance(there, sceneMm.centre());
    if (std::isfinite(forwardMm) && (nowMm <= sceneMm.diagonal() || nowMm < beforeMm))
        camera.targetMm = there;
    return camera;
}

double mmPerPixel(const OrbitCamera& camera, double heightPx) {
    return heightAtTargetMm(toCamera(camera)) / std::max(heightPx, 1.0);
}

OrbitCamera pannedByDrag(OrbitCamera camera, double dxPx, double dyPx, double heightPx) {
    const Directions d = directions(camera);
    camera.targetMm += mmPerPixel(camera, heightPx) * (dyPx * d.up - dxPx * d.right);
    return camera;
}

OrbitCamera zoomed(OrbitCamera camera, double magnification, double sceneDiagonalMm) {
    const double wanted = camera.distanceMm / std::max(magnification, 1e-6);
    camera.distanceMm =
        std::clamp(wanted, kNearestOfDiagonal * sceneDiagonalMm, kFarthestOfDiagonal * sceneDiagonalMm);
    return camera;
}

EdgeLetters edgeLetters(const OrbitCamera& camera) {
    const Directions d = directions(camera);
    return {.left = orientationLetters(-d.right),
            .right = orientationLetters(d.right),
            .top = orientationLetters(d.up),
            .bottom = orientationLetters(-d.up)};
}

}  // namespace macula::scene
