// SliceSteps numbers the parallel planes that the wheel steps through in a pane.
#pragma once

#include <optional>

#include "slices/slice_plane.h"

namespace macula::viewer {

// How a person has turned the planes of all panes.
struct PlaneTurn {
    glm::dquat turn{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 aboutMm{0.0};

    bool operator==(const PlaneTurn&) const = default;
};

// The plane of a pane through the middle of the volume before a person turns it: the patient's, or parallel
// to the images. The three are perpendicular to each other.
slices::SlicePlane planeBeforeTurn(const Volume& volume, slices::Orientation orientation, bool asAcquired);

// Parallel planes through a volume, slices::stepMm apart. Where voxel planes are parallel to them, slice i is
// the middle of voxel plane i, so that the picture shows acquired values; else the planes are spaced along
// the normal. Of turned planes one contains the point that they are turned about.
class SliceSteps {
  public:
    // `asAcquired` turns the planes parallel to the images; `turn` turns them from there.
    SliceSteps(const Volume& volume, slices::Orientation orientation, bool asAcquired,
               const std::optional<PlaneTurn>& turn = {});

    int count() const { return count_; }  // at least 1
    // The distance from one slice to the next along the normal; negative where voxel indices decrease along
    // it.
    double stepMm() const { return stepMm_; }
    int nearest(const glm::dvec3& mm) const;
    // The point of that slice that is nearest to `mm`.
    glm::dvec3 onSlice(int index, const glm::dvec3& mm) const;
    slices::SlicePlane plane(int index, const glm::dvec3& centreMm) const;

    // Whether each slice is a plane of the images, taken or missing: its index is then the voxel index.
    bool areAcquired() const { return areAcquired_; }
    // Whether the planes are perpendicular to an axis of the patient.
    bool areStraight() const { return areStraight_; }
    // The angle between the normals before and after a person turned them, 0 to 90.
    double turnedDeg() const { return turnedDeg_; }

  private:
    void alongVoxels(const Volume& volume);
    void alongNormal(const Volume& volume);
    void passThrough(const glm::dvec3& mm);

    slices::SlicePlane directions_;  // its centre is the middle of the volume
    glm::dvec3 normal_;
    double firstMm_ = 0.0;  // along the normal, from the patient's origin
    double stepMm_ = 1.0;
    int count_ = 0;
    bool areAcquired_ = false;
    bool areStraight_ = true;
    double turnedDeg_ = 0.0;
};

// The middle between the outermost voxels, patient LPS mm.
glm::dvec3 middleMm(const Volume& volume);

}  // namespace macula::viewer
