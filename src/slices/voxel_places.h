// Between places in the patient and those among the voxels of a volume.
#pragma once

#include <glm/glm.hpp>

#include "base/volume.h"
#include "slices/voxel_grid.h"

namespace macula::slices {

// Where voxels are: half a voxel outside of the outer middles.
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

// From voxel coordinates to those of the patient and back. The origin is subtracted before the turn, so that
// far from the origin of the patient's coordinates no digits are lost.
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
