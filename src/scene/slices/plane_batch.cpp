#include "scene/slices/plane_batch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace macula::scene {

namespace {

constexpr double kMostMm = 1e5;

Error noPlanes(Text message) {
    return {ErrorCode::usage,
            std::move(message),
            {},
            Text("Choose other distances, or another number of planes.")};
}

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isUsable(const PlaneBatch& batch) {
    const bool isPlane = batch.like.isUsable() && batch.like.sizePx.x > 0 && batch.like.sizePx.y > 0 &&
                         isFinite(batch.like.plane.centreMm);
    if (!batch.radial)
        return isPlane && std::abs(batch.fromMm) < kMostMm && std::abs(batch.toMm) < kMostMm &&
               std::abs(batch.stepMm) < kMostMm && batch.stepMm != 0.0;
    constexpr double kUnit = 1e-3;
    return isPlane && batch.radial->count >= 1 && isFinite(batch.radial->throughMm) &&
           std::abs(glm::length(batch.radial->axis) - 1.0) < kUnit;
}

std::vector<slices::SlicePlane> parallelPlanes(const PlaneBatch& batch, std::size_t count) {
    const glm::dvec3 normal = batch.like.plane.normal();
    const double step = batch.toMm < batch.fromMm ? -std::abs(batch.stepMm) : std::abs(batch.stepMm);
    std::vector<slices::SlicePlane> planes(count, batch.like.plane);
    for (std::size_t n = 0; n < count; ++n) planes[n].centreMm += (batch.fromMm + double(n) * step) * normal;
    return planes;
}

// The first one shows the axis downwards, and lies as near to `like` as it can.
std::vector<slices::SlicePlane> radialPlanes(const PlaneBatch& batch) {
    const PlaneBatch::Radial& radial = *batch.radial;
    glm::dvec3 down = glm::normalize(radial.axis);
    // Upright where the axis is that of the body: the head is above.
    const bool isAlongBody = std::abs(down.z) > std::max(std::abs(down.x), std::abs(down.y));
    if (isAlongBody ? down.z > 0.0 : glm::dot(down, batch.like.plane.down) < 0.0) down = -down;
    const auto across = [&](const glm::dvec3& v) { return v - glm::dot(v, down) * down; };
    glm::dvec3 first = across(batch.like.plane.right);
    if (glm::length(first) < 0.5) first = across(batch.like.plane.down);
    first = glm::normalize(first);
    const glm::dvec3 second = glm::cross(first, down);  // away from the viewer of the first
    std::vector<slices::SlicePlane> planes;
    for (int n = 0; n < radial.count; ++n) {
        const double angle = std::numbers::pi * double(n) / double(radial.count);
        planes.push_back({.centreMm = radial.throughMm,
                          .right = std::cos(angle) * first + std::sin(angle) * second,
                          .down = down});
    }
    return planes;
}

}  // namespace

Result<std::vector<slices::SliceFrame>> framesOf(const PlaneBatch& batch, double mmPerPixel) {
    if (!isUsable(batch) || !(mmPerPixel > 0.0) || !std::isfinite(mmPerPixel))
        return noPlanes(Text("These numbers make no planes."));
    constexpr double kRounding = 1e-6;
    const double parallel =
        std::floor(std::abs(batch.toMm - batch.fromMm) / std::abs(batch.stepMm) + kRounding) + 1.0;
    const double count = batch.radial ? double(batch.radial->count) : parallel;
    if (count > double(kMostPlanes)) return noPlanes(Text("These are more than {} planes.", kMostPlanes));
    const glm::dvec2 sides = glm::dvec2(batch.like.sizePx) * batch.like.mmPerPixel / mmPerPixel;
    const glm::dvec2 px = glm::max(glm::round(sides), glm::dvec2(1.0));
    if (std::max(px.x, px.y) > double(kMostPlanePx))
        return noPlanes(Text("A plane would have more than {} pixels a side.", kMostPlanePx));
    std::vector<slices::SliceFrame> frames;
    for (const slices::SlicePlane& plane :
         batch.radial ? radialPlanes(batch) : parallelPlanes(batch, std::size_t(count)))
        frames.push_back({.plane = plane, .mmPerPixel = mmPerPixel, .sizePx = glm::ivec2(px)});
    return frames;
}

double mmPerPixelOf(const PlaneBatch& batch, const Volume& volume) {
    const glm::dvec3 voxel = volume.spacingMm();
    const double longest = double(std::max(batch.like.sizePx.x, batch.like.sizePx.y)) * batch.like.mmPerPixel;
    return std::max(std::min({voxel.x, voxel.y, voxel.z}), longest / double(kMostPlanePx - 1));
}

}  // namespace macula::scene
