#include "scene/slices/opening_planes.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace macula::scene {

namespace {

constexpr double kTilted = 0.9962;  // the cosine of 5 degrees
constexpr double kThin = 0.4;       // fraction of the shorter side of an image

// The size of the volume along its three voxel axes.
glm::dvec3 extentMm(const Volume& volume) {
    glm::dvec3 extent;
    for (int axis = 0; axis < 3; ++axis)
        extent[axis] = glm::length(glm::dvec3(volume.worldFromVoxel()[axis])) * volume.size()[axis];
    return extent;
}

}  // namespace

OpeningPlanes openingPlanes(const Volume& volume) {
    const slices::Orientation orientation = slices::acquiredOrientation(volume);
    const slices::SlicePlane images = slices::acquiredPlane(volume, {});
    const slices::SlicePlane patients = slices::planeOf(orientation, {});
    OpeningPlanes planes;
    planes.asAcquired =
        std::min({glm::dot(images.right, patients.right), glm::dot(images.down, patients.down),
                  glm::dot(images.normal(), patients.normal())}) < kTilted;
    const glm::dvec3 extent = extentMm(volume);
    if (extent.z < kThin * std::min(extent.x, extent.y)) planes.largest = orientation;
    return planes;
}

}  // namespace macula::scene
