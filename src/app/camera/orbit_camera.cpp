#include "app/camera/orbit_camera.h"

#include <algorithm>
#include <cmath>

namespace macula::app {

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
    const glm::dvec3 up = -std::sin(elevation) * outward + std::cos(elevation) * superior;
    return {eye, up, glm::cross(-eye, up)};
}

double wrapped(double degrees) {
    return degrees - 360.0 * std::floor((degrees + 180.0) / 360.0);
}

}  // namespace

Camera toCamera(const OrbitCamera& camera) {
    const Directions d = directions(camera);
    return {.positionMm = camera.targetMm + camera.distanceMm * d.eye,
            .targetMm = camera.targetMm,
            .up = d.up,
            .verticalFovDeg = camera.verticalFovDeg};
}

OrbitCamera orbitCameraOf(const Camera& camera) {
    const glm::dvec3 toEye = camera.positionMm - camera.targetMm;
    const double distanceMm = glm::length(toEye);
    const glm::dvec3 eye = toEye / distanceMm;
    // Above and below, the upright of the picture says how the turntable stands.
    constexpr double kAtThePole = 1e-9;
    glm::dvec3 outward = eye;
    if (std::hypot(eye.x, eye.y) < kAtThePole) outward = eye.z > 0.0 ? -camera.up : camera.up;
    return {.targetMm = camera.targetMm,
            .distanceMm = distanceMm,
            .azimuthDeg = wrapped(glm::degrees(std::atan2(outward.x, -outward.y))),
            .elevationDeg = glm::degrees(std::asin(std::clamp(eye.z, -1.0, 1.0))),
            .verticalFovDeg = camera.verticalFovDeg};
}

OrbitCamera fitted(OrbitCamera camera, std::span<const glm::dvec3> pointsMm, double aspectWidthOverHeight) {
    const Directions d = directions(camera);
    const Camera straight = framePoints(pointsMm, {.right = d.right, .up = d.up, .forward = -d.eye},
                                        camera.verticalFovDeg, aspectWidthOverHeight);
    camera.targetMm = straight.targetMm;
    camera.distanceMm = glm::distance(straight.positionMm, straight.targetMm);
    return camera;
}

OrbitCamera framed(std::span<const glm::dvec3> pointsMm, ViewDirection from, double verticalFovDeg,
                   double aspectWidthOverHeight) {
    OrbitCamera camera{.verticalFovDeg = verticalFovDeg};
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
    }
    return fitted(camera, pointsMm, aspectWidthOverHeight);
}

OrbitCamera orbited(OrbitCamera camera, double azimuthDeg, double elevationDeg) {
    camera.azimuthDeg = wrapped(camera.azimuthDeg + azimuthDeg);
    camera.elevationDeg = std::clamp(camera.elevationDeg + elevationDeg, -90.0, 90.0);
    return camera;
}

OrbitCamera orbitedByDrag(const OrbitCamera& camera, double dxPx, double dyPx, double heightPx) {
    const double degreesPerPixel = kDegreesPerPictureHeight / std::max(heightPx, 1.0);
    return orbited(camera, -dxPx * degreesPerPixel, dyPx * degreesPerPixel);
}

OrbitCamera pannedByDrag(OrbitCamera camera, double dxPx, double dyPx, double heightPx) {
    const Directions d = directions(camera);
    const double planeHeightMm =
        2.0 * camera.distanceMm * std::tan(glm::radians(camera.verticalFovDeg) / 2.0);
    const double mmPerPixel = planeHeightMm / std::max(heightPx, 1.0);
    camera.targetMm += mmPerPixel * (dyPx * d.up - dxPx * d.right);
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

}  // namespace macula::app
