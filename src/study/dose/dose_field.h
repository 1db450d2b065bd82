// A dose at any place: interpolated between the points of its grid.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/volume.h"

namespace macula::study {

// In double precision. Keeps the volume; safe to read from any thread.
class DoseField {
  public:
    explicit DoseField(std::shared_ptr<const Volume> volume);

    // Trilinear between the eight points around `mm`, patient LPS; those without a value are left out, with
    // their weights. Nothing outside the outermost points of the grid, where nobody computed a dose, and
    // where none of the eight has a value. A grid of one plane has its dose half a voxel to both sides of it.
    std::optional<double> at(const glm::dvec3& mm) const;
    // Whether the place, patient LPS mm, is not outside as above.
    bool covers(const glm::dvec3& mm) const;

    const Volume& volume() const { return *volume_; }

  private:
    glm::dvec3 voxelAt(const glm::dvec3& mm) const { return voxelFromMm_ * (mm - originMm_); }

    std::shared_ptr<const Volume> volume_;
    glm::dmat3 voxelFromMm_;
    glm::dvec3 originMm_;
};

}  // namespace macula::study
