#include "scene/camera/picture_rays.h"

#include <cmath>

#include "base/is_finite.h"

namespace macula::scene {

namespace {

constexpr double kParallel = 1e-4;  // a ray counts as parallel below this sine to a line, cosine to a normal

}  // namespace

std::optional<PictureRays> PictureRays::of(const Camera& camera, double aspectWidthOverHeight) {
    const Result<CameraBasis> axes = basis(camera);
    if (!axes || !std::isfinite(aspectWidthOverHeight) || !(aspectWidthOverHeight > 0.0)) return std::nullopt;
    return PictureRays(camera, *axes, aspectWidthOverHeight);
}

PictureRays::PictureRays(const Camera& camera, const CameraBasis& axes, double aspect)
    : originMm_(camera.positionMm),
      axes_(axes),
      isParallel_(isParallel(camera)),
      halfHeight_(isParallel_ ? 0.5 * camera.parallelHeightMm
                              : std::tan(0.5 * glm::radians(camera.verticalFovDeg))),
      aspect_(aspect) {}

PictureRay PictureRays::through(const glm::dvec2& place) const {
    const glm::dvec2 off = halfHeight_ * halfHeights(place);
    const glm::dvec3 across = off.x * axes_.right + off.y * axes_.up;
    if (isParallel_)
        return {.originMm = originMm_ + across, .direction = axes_.forward, .beginsThere = false};
    return {.originMm = originMm_, .direction = glm::normalize(axes_.forward + across)};
}

std::optional<glm::dvec2> PictureRays::placeOf(const glm::dvec3& mm) const {
    const glm::dvec3 at = homogeneous(mm);
    if (!(at.z > 0.0) || !isFinite(at)) return std::nullopt;
    return glm::dvec2(at.x / at.z / aspect_, at.y / at.z);
}

glm::dvec3 PictureRays::homogeneous(const glm::dvec3& mm) const {
    return homogeneousStep(mm - originMm_) + glm::dvec3(0.0, 0.0, isParallel_ ? halfHeight_ : 0.0);
}

glm::dvec3 PictureRays::homogeneousStep(const glm::dvec3& byMm) const {
    return {glm::dot(byMm, axes_.right), glm::dot(byMm, axes_.up),
            isParallel_ ? 0.0 : halfHeight_ * glm::dot(byMm, axes_.forward)};
}

std::optional<double> nearestOnLine(const PictureRay& ray, const glm::dvec3& pointMm,
                                    const glm::dvec3& direction) {
    const double length = glm::length(direction);
    if (!(length > 0.0)) return std::nullopt;
    const glm::dvec3 along = direction / length;
    const double cosine = glm::dot(ray.direction, along);
    const double sine2 = 1.0 - cosine * cosine;
    if (!(sine2 > kParallel * kParallel)) return std::nullopt;
    const glm::dvec3 from = pointMm - ray.originMm;
    const double onRay = glm::dot(from, ray.direction);
    const double onLine = glm::dot(from, along);
    if (ray.beginsThere && !((onRay - cosine * onLine) / sine2 > 0.0)) return std::nullopt;
    return (cosine * onRay - onLine) / sine2 / length;
}

std::optional<glm::dvec3> meets(const PictureRay& ray, const glm::dvec3& pointMm, const glm::dvec3& normal) {
    const double towards = glm::dot(ray.direction, normal);
    if (!(std::abs(towards) > kParallel * glm::length(normal))) return std::nullopt;
    const double mm = glm::dot(pointMm - ray.originMm, normal) / towards;
    if (!std::isfinite(mm) || (ray.beginsThere && !(mm > 0.0))) return std::nullopt;
    return ray.at(mm);
}

}  // namespace macula::scene
