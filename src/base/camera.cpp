#include "base/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/is_finite.h"

namespace macula {

namespace {

constexpr double kMinFovDeg = 0.1;
constexpr double kMaxFovDeg = 170.0;
constexpr double kFramingMargin = 1.04;
constexpr double kBeforeOfDiagonal = 0.01;  // of the diagonal: how far before the box moved rays begin

struct StandardView {
    glm::dvec3 fromDirection;  // from the target to the eye, LPS
    glm::dvec3 up;
};

StandardView obliqueView(const Obliqueness& by) {
    const double azimuth = glm::radians(by.azimuthDeg);
    const double elevation = glm::radians(by.elevationDeg);
    const glm::dvec3 level(std::sin(azimuth), -std::cos(azimuth), 0.0);
    const glm::dvec3 superior(0, 0, 1);
    return {level * std::cos(elevation) + superior * std::sin(elevation),
            superior * std::cos(elevation) - level * std::sin(elevation)};
}

StandardView standardView(ViewDirection direction) {
    const glm::dvec3 superior{0, 0, 1};
    const glm::dvec3 anterior{0, -1, 0};
    switch (direction) {
        case ViewDirection::anterior:
            return {{0, -1, 0}, superior};
        case ViewDirection::posterior:
            return {{0, 1, 0}, superior};
        case ViewDirection::left:
            return {{1, 0, 0}, superior};
        case ViewDirection::right:
            return {{-1, 0, 0}, superior};
        case ViewDirection::superior:
            return {{0, 0, 1}, anterior};
        case ViewDirection::inferior:
            return {{0, 0, -1}, anterior};
        case ViewDirection::oblique:
        case ViewDirection::threeQuarter:
        case ViewDirection::turned:
            return obliqueView(obliquenessOf(direction));
    }
    return {{0, -1, 0}, superior};
}

double tangentOfHalf(double verticalFovDeg) {
    return std::tan(glm::radians(verticalFovDeg) / 2.0);
}

}  // namespace

Result<CameraBasis> basis(const Camera& camera) {
    const auto fail = [](Text message) {
        return Error{ErrorCode::usage, std::move(message), {}, Text("Correct the camera.")};
    };
    if (!isFinite(camera.positionMm) || !isFinite(camera.targetMm) || !isFinite(camera.up)) {
        return fail(Text("The camera has a number that is not finite."));
    }
    if (!(camera.verticalFovDeg >= kMinFovDeg && camera.verticalFovDeg <= kMaxFovDeg)) {
        return fail(Text("The camera's vertical field of view must lie between 0.1 and 170 degrees."));
    }
    if (camera.parallelHeightMm != 0.0 &&
        !(camera.parallelHeightMm >= kLeastParallelMm && camera.parallelHeightMm <= kMostParallelMm)) {
        return fail(Text("The height of a parallel picture must lie between 0.001 mm and 1 km."));
    }
    const glm::dvec3 view = camera.targetMm - camera.positionMm;
    const double distance = glm::length(view);
    if (!(distance > 0.0)) return fail(Text("The camera's position and target are the same point."));
    const glm::dvec3 forward = view / distance;
    const glm::dvec3 side = glm::cross(forward, camera.up);
    const double sine = glm::length(side) / std::max(glm::length(camera.up), 1e-300);
    if (!(sine > 1e-6)) return fail(Text("The camera's up direction is parallel to its view."));
    const glm::dvec3 right = glm::normalize(side);
    return CameraBasis{right, glm::cross(right, forward), forward};
}

double heightAtTargetMm(const Camera& camera) {
    if (isParallel(camera)) return camera.parallelHeightMm;
    return 2.0 * glm::distance(camera.positionMm, camera.targetMm) * tangentOfHalf(camera.verticalFovDeg);
}

Camera inParallel(Camera camera) {
    camera.parallelHeightMm = std::clamp(heightAtTargetMm(camera), kLeastParallelMm, kMostParallelMm);
    return camera;
}

Camera inPerspective(Camera camera) {
    if (!isParallel(camera)) return camera;
    const glm::dvec3 toEye = camera.positionMm - camera.targetMm;
    const double distanceMm = 0.5 * camera.parallelHeightMm / tangentOfHalf(camera.verticalFovDeg);
    camera.positionMm = camera.targetMm + toEye * (distanceMm / glm::length(toEye));
    camera.parallelHeightMm = 0.0;
    return camera;
}

Camera standingBefore(Camera camera, const Box& box) {
    if (!isParallel(camera)) return camera;
    const glm::dvec3 view = camera.targetMm - camera.positionMm;
    const double distanceMm = glm::length(view);
    if (!(distanceMm > 0.0)) return camera;
    double behindMm = 0.0;  // how far behind the start of the rays the box reaches
    for (const glm::dvec3& corner : cornersOf(box))
        behindMm = std::max(behindMm, glm::dot(camera.positionMm - corner, view / distanceMm));
    if (behindMm > 0.0)
        camera.positionMm -= (behindMm + kBeforeOfDiagonal * box.diagonal()) / distanceMm * view;
    return camera;
}

CameraBasis standardBasis(ViewDirection from) {
    const StandardView view = standardView(from);
    return {.right = glm::cross(-view.fromDirection, view.up), .up = view.up, .forward = -view.fromDirection};
}

Camera framePoints(std::span<const glm::dvec3> pointsMm, const CameraBasis& axes, double verticalFovDeg,
                   double aspectWidthOverHeight) {
    MACULA_CHECK(!pointsMm.empty());
    const double halfHeight = kFittedPart * std::tan(glm::radians(verticalFovDeg) / 2.0);
    const glm::dvec2 half(halfHeight * aspectWidthOverHeight, halfHeight);
    // Each point at p (across) and w (along the view) is in the middle part of the picture of an eye at e
    // (across) and g (along) if |p - e| <= half (w - g). So e lies between low + half g and high - half g,
    // and the eye may advance (g) until the two meet.
    glm::dvec2 low(-std::numeric_limits<double>::infinity());
    glm::dvec2 high(std::numeric_limits<double>::infinity());
    Box box{glm::dvec3(high.x), glm::dvec3(low.x)};
    for (const glm::dvec3& point : pointsMm) {
        const glm::dvec2 across(glm::dot(point, axes.right), glm::dot(point, axes.up));
        const double along = glm::dot(point, axes.forward);
        low = glm::max(low, across - half * along);
        high = glm::min(high, across + half * along);
        box = {glm::min(box.low, point), glm::max(box.high, point)};
    }
    const glm::dvec2 room = (high - low) / (2.0 * half);
    const double nearest = std::min(room.x, room.y);
    // The eye keeps a distance, however small the points' box is.
    const double target = glm::dot(box.centre(), axes.forward);
    const double along = std::min(nearest, target - std::max(1e-6 * std::abs(target), 1e-9));
    const glm::dvec2 across = 0.5 * (low + high);
    const glm::dvec3 eye = axes.right * across.x + axes.up * across.y + axes.forward * along;
    return {.positionMm = eye,
            .targetMm = eye + axes.forward * (target - along),
            .up = axes.up,
            .verticalFovDeg = verticalFovDeg};
}

Camera frameInParallel(std::span<const glm::dvec3> pointsMm, const CameraBasis& axes, double verticalFovDeg,
                       double aspectWidthOverHeight) {
    MACULA_CHECK(!pointsMm.empty());
    Box box{glm::dvec3(std::numeric_limits<double>::infinity()),
            glm::dvec3(-std::numeric_limits<double>::infinity())};  // along right, up, forward
    for (const glm::dvec3& point : pointsMm) {
        const glm::dvec3 along(glm::dot(point, axes.right), glm::dot(point, axes.up),
                               glm::dot(point, axes.forward));
        box = {glm::min(box.low, along), glm::max(box.high, along)};
    }
    const glm::dvec3 size = box.high - box.low;
    const double heightMm = std::clamp(std::max(size.y, size.x / aspectWidthOverHeight) / kFittedPart,
                                       kLeastParallelMm, kMostParallelMm);
    const glm::dvec3 middle = box.centre();
    const glm::dvec3 targetMm = axes.right * middle.x + axes.up * middle.y + axes.forward * middle.z;
    const double distanceMm = 0.5 * heightMm / tangentOfHalf(verticalFovDeg);
    Camera camera;
    camera.positionMm = targetMm - axes.forward * std::max(distanceMm, size.z);
    camera.targetMm = targetMm;
    camera.up = axes.up;
    camera.verticalFovDeg = verticalFovDeg;
    camera.parallelHeightMm = heightMm;
    return camera;
}

Camera frameBox(const Box& box, ViewDirection from, double verticalFovDeg, double aspectWidthOverHeight) {
    const StandardView view = standardView(from);
    const glm::dvec3 right = glm::cross(-view.fromDirection, view.up);
    const glm::dvec3 half = 0.5 * (box.high - box.low);
    const double halfWidth = glm::dot(glm::abs(right), half);
    const double halfHeight = glm::dot(glm::abs(view.up), half);
    const double halfDepth = glm::dot(glm::abs(view.fromDirection), half);
    const double tanHalf = std::tan(glm::radians(verticalFovDeg) / 2.0);
    // The near face of the box must fit.
    const double distance =
        halfDepth + kFramingMargin * std::max(halfHeight, halfWidth / aspectWidthOverHeight) / tanHalf;
    return {.positionMm = box.centre() + distance * view.fromDirection,
            .targetMm = box.centre(),
            .up = view.up,
            .verticalFovDeg = verticalFovDeg};
}

}  // namespace macula
