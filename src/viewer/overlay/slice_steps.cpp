#include "viewer/overlay/slice_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::viewer {

namespace {

// Unit vectors closer than this count as one direction: 0.05 mm at the edge of a body, far above the rounding
// of numbers in files.
constexpr double kSameDirection = 1e-4;

bool areParallel(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(glm::cross(a, b)) < kSameDirection;
}

// Turns `plane` by the rotation from the patient's nearest plane to the acquired plane.
slices::SlicePlane turned(const slices::SlicePlane& plane, const Volume& volume) {
    const slices::SlicePlane to = slices::acquiredPlane(volume, plane.centreMm);
    const slices::SlicePlane from = slices::planeOf(slices::acquiredOrientation(volume), plane.centreMm);
    const glm::dmat3 rotation = glm::dmat3(to.right, to.down, to.normal()) *
                                glm::transpose(glm::dmat3(from.right, from.down, from.normal()));
    return {.centreMm = plane.centreMm,
            .right = glm::normalize(rotation * plane.right),
            .down = glm::normalize(rotation * plane.down)};
}

}  // namespace

glm::dvec3 middleMm(const Volume& volume) {
    return transformPoint(volume.worldFromVoxel(), 0.5 * glm::dvec3(volume.size() - 1));
}

slices::SlicePlane planeBeforeTurn(const Volume& volume, slices::Orientation orientation, bool asAcquired) {
    const slices::SlicePlane straight = slices::planeOf(orientation, middleMm(volume));
    return asAcquired ? turned(straight, volume) : straight;
}

SliceSteps::SliceSteps(const Volume& volume, slices::Orientation orientation, bool asAcquired,
                       const std::optional<PlaneTurn>& turn)
    : directions_(planeBeforeTurn(volume, orientation, asAcquired)) {
    const glm::dvec3 before = directions_.normal();
    if (turn) directions_ = slices::tilted(directions_, turn->turn);
    normal_ = directions_.normal();
    areStraight_ = areParallel(normal_, slices::planeOf(orientation, {}).normal());
    turnedDeg_ =
        glm::degrees(std::atan2(glm::length(glm::cross(before, normal_)), glm::dot(before, normal_)));
    alongVoxels(volume);
    if (count_ > 0) return;
    alongNormal(volume);
    if (turn) passThrough(turn->aboutMm);
}

// Moves the planes by less than a step. The point is in the volume, so none of them leaves it entirely.
void SliceSteps::passThrough(const glm::dvec3& mm) {
    const double index = (glm::dot(mm, normal_) - firstMm_) / stepMm_;
    if (std::isfinite(index)) firstMm_ += (index - std::round(index)) * stepMm_;
}

// Voxel planes of an axis are perpendicular to the gradient of its index.
void SliceSteps::alongVoxels(const Volume& volume) {
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    for (int axis = 2; axis >= 0; --axis) {
        const glm::dvec3 gradient{voxelFromWorld[0][axis], voxelFromWorld[1][axis], voxelFromWorld[2][axis]};
        if (!areParallel(glm::normalize(gradient), normal_)) continue;
        const double indicesPerMm = glm::dot(gradient, normal_);
        // Measured in the middle of the volume, where planes that are not quite parallel agree best.
        const double middle = 0.5 * (volume.size()[axis] - 1);
        stepMm_ = 1.0 / indicesPerMm;
        firstMm_ = glm::dot(directions_.centreMm, normal_) - middle * stepMm_;
        count_ = volume.size()[axis];
        areAcquired_ = axis == 2;
        return;
    }
}

void SliceSteps::alongNormal(const Volume& volume) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 voxel(-0.5);
        for (int axis = 0; axis < 3; ++axis)
            if ((corner >> axis & 1) != 0) voxel[axis] += volume.size()[axis];
        const double along = glm::dot(transformPoint(volume.worldFromVoxel(), voxel), normal_);
        low = std::min(low, along);
        high = std::max(high, along);
    }
    stepMm_ = slices::stepMm(volume, directions_);
    // A volume with few, very long voxels may be billions of steps long.
    constexpr double kMost = 1e6;
    count_ = int(std::clamp(std::floor((high - low) / stepMm_), 1.0, kMost));
    firstMm_ = 0.5 * (low + high) - 0.5 * (count_ - 1) * stepMm_;
}

int SliceSteps::nearest(const glm::dvec3& mm) const {
    const double index = (glm::dot(mm, normal_) - firstMm_) / stepMm_;
    if (std::isnan(index)) return count_ / 2;
    return int(std::lround(std::clamp(index, 0.0, double(count_ - 1))));
}

glm::dvec3 SliceSteps::onSlice(int index, const glm::dvec3& mm) const {
    const double position = firstMm_ + index * stepMm_;
    return mm + normal_ * (position - glm::dot(mm, normal_));
}

slices::SlicePlane SliceSteps::plane(int index, const glm::dvec3& centreMm) const {
    slices::SlicePlane plane = directions_;
    plane.centreMm = onSlice(index, centreMm);
    return plane;
}

}  // namespace macula::viewer
