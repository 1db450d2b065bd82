// Converts patient coordinates to voxel coordinates of a volume.
#pragma once

#include <glm/glm.hpp>

#include "base/volume.h"
#include "slices/voxel_grid.h"

namespace macula::slices {

// Voxel coordinates that the volume covers: to half a voxel + kSamePlace beyond the outer centres.
struct Bounds {
    glm::dvec3 low{0.0};
    glm::dvec3 high{0.0};

    bool contain(const glm::dvec3& at) const {
        return glm::all(glm::lessThanEqual(low, at)) && glm::all(glm::lessThanEqual(at, high));
    }
};

inline Bounds boundsOf(const glm::ivec3& size) {
    const double beyond = 0.5 + kSamePlace;
    return {glm::dvec3(-beyond), glm::dvec3(size - 1) + beyond};
}

// Converts patient LPS mm to voxel coordinates. The origin is subtracted before the rotation, so that volumes
// far from the patient's origin lose no digits.
class VoxelPlaces {
  public:
    explicit VoxelPlaces(const Volume& volume)
        : voxelFromMm_(glm::inverse(glm::dmat3(volume.worldFromVoxel()))),
          originMm_(volume.worldFromVoxel()[3]) {}

    glm::dvec3 ofPoint(const glm::dvec3& mm) const { return voxelFromMm_ * (mm - originMm_); }
    glm::dvec3 ofVector(const glm::dvec3& mm) const { return voxelFromMm_ * mm; }

  private:
    glm::dmat3 voxelFromMm_;
    glm::dvec3 originMm_;
};

}  // namespace macula::slices
