// SliceSteps numbers the parallel planes that the wheel goes through in a pane.
#pragma once

#include <optional>

#include "slices/slice_plane.h"

namespace macula::viewer {

// Parallel planes through a volume, slices::stepMm apart. Where voxel planes are parallel to them, each lies
// in the middle of one, so that what is seen is what was taken, and the first is that of voxel 0; else they
// go along the normal.
class SliceSteps {
  public:
    // As acquired: turned with the planes in which the images were taken, so that panes stay perpendicular.
    SliceSteps(const Volume& volume, slices::Orientation orientation, bool asAcquired);

    int count() const { return count_; }  // at least 1
    // From one slice to the next along the normal; negative where voxels are counted against it.
    double stepMm() const { return stepMm_; }
    int nearest(const glm::dvec3& mm) const;
    // The point of that slice that is nearest to `mm`.
    glm::dvec3 onSlice(int index, const glm::dvec3& mm) const;
    slices::SlicePlane plane(int index, const glm::dvec3& centreMm) const;

    // Whether each is a plane in which an image was taken, or would have been: its index is that of the
    // voxel.
    bool areAcquired() const { return areAcquired_; }
    // Whether they are those of the patient's axes.
    bool areStraight() const { return areStraight_; }

  private:
    void alongVoxels(const Volume& volume);
    void alongNormal(const Volume& volume);

    slices::SlicePlane directions_;  // its centre is the middle of the volume
    glm::dvec3 normal_;
    double firstMm_ = 0.0;  // along the normal, from the patient's origin
    double stepMm_ = 1.0;
    int count_ = 0;
    bool areAcquired_ = false;
    bool areStraight_ = true;
};

// Between the outermost voxels.
glm::dvec3 middleMm(const Volume& volume);

}  // namespace macula::viewer
