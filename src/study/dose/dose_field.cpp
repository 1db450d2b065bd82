#include "study/dose/dose_field.h"

#include <cmath>
#include <utility>

#include "slices/voxel_grid.h"

namespace macula::study {

namespace {

// How far outside the outermost points a place may lie, in voxels.
glm::dvec3 reachOf(const glm::ivec3& size) {
    glm::dvec3 reach(slices::kSamePlace);
    for (int axis = 0; axis < 3; ++axis)
        if (size[axis] == 1) reach[axis] += 0.5;
    return reach;
}

}  // namespace

DoseField::DoseField(std::shared_ptr<const Volume> volume)
    : volume_(std::move(volume)),
      voxelFromMm_(glm::inverse(glm::dmat3(volume_->worldFromVoxel()))),
      originMm_(volume_->worldFromVoxel()[3]) {}

// NaN is not covered either.
bool DoseField::covers(const glm::dvec3& mm) const {
    const glm::dvec3 at = voxelAt(mm);
    const glm::ivec3& size = volume_->size();
    const glm::dvec3 reach = reachOf(size);
    return glm::all(glm::greaterThanEqual(at, -reach)) &&
           glm::all(glm::lessThanEqual(at, glm::dvec3(size - 1) + reach));
}

std::optional<double> DoseField::at(const glm::dvec3& mm) const {
    if (!covers(mm)) return std::nullopt;
    const glm::dvec3 at = voxelAt(mm);
    const double value = volume_->format() == VoxelFormat::float32
                             ? slices::VoxelGrid<slices::FloatVoxels>(*volume_).linear(at)
                             : slices::VoxelGrid<slices::StoredVoxels>(*volume_).linear(at);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace macula::study
