// The plane of a slice, and the picture of it: reformatted images (PS3.3 C.8.32 calls them MPR), in patient
// LPS mm.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>

#include "base/frames.h"
#include "base/volume.h"

namespace macula::slices {

enum class Orientation { axial, coronal, sagittal };

// Oriented as radiologists view it: the patient's right is on the left of an axial and a coronal picture,
// anterior on the left of a sagittal one. right and down are perpendicular unit vectors.
struct SlicePlane {
    glm::dvec3 centreMm{0.0};  // in the middle of the picture
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 down{0.0, 1.0, 0.0};

    // Away from the viewer: towards the head in an axial picture.
    glm::dvec3 normal() const { return glm::cross(right, down); }
    // Finite; right and down are unit vectors and perpendicular, to a thousandth.
    bool isUsable() const;
    bool operator==(const SlicePlane&) const = default;
};

SlicePlane planeOf(Orientation orientation, const glm::dvec3& centreMm);

// The plane in which the slices of the volume were taken, with its axes swapped or negated to be nearest to
// planeOf the nearest orientation, but never mirrored: its normal is within 90 degrees of that plane's. With
// a tilted gantry the normal is not the direction from slice to slice.
SlicePlane acquiredPlane(const Volume& volume, const glm::dvec3& centreMm);
Orientation acquiredOrientation(const Volume& volume);

// The turn by the least angle that takes one unit vector to another. For opposite vectors it is half a turn
// about `ifOpposite`, a unit vector perpendicular to both.
glm::dquat leastTurn(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& ifOpposite);

// The plane whose normal is `turn` times that of `plane`, or the opposite one: nothing is ever seen from
// behind. In the picture it turns as little as that allows, so that a turn about the normal changes nothing.
// Keeps the centre.
SlicePlane tilted(const SlicePlane& plane, const glm::dquat& turn);

// A picture on a plane. Its pixels are square; (0, 0) is the upper left corner of the picture, and the centre
// of the first pixel is (0.5, 0.5).
struct SliceFrame {
    SlicePlane plane;
    double mmPerPixel = 1.0;
    glm::ivec2 sizePx{0};

    glm::dvec3 worldFromPicture(const glm::dvec2& px) const;
    // The pixel of the plane's point nearest to `mm`. Not finite if mmPerPixel is 0.
    glm::dvec2 pictureFromWorld(const glm::dvec3& mm) const;
    double distanceMm(const glm::dvec3& mm) const;  // from the plane, positive along its normal
    // Whether its plane is usable, and mmPerPixel is finite and above 0. It may have no pixels.
    bool isUsable() const;
    bool operator==(const SliceFrame&) const = default;
};

// Distances from a plane along its normal.
struct DepthRange {
    double lowMm = 0.0;
    double highMm = 0.0;
};
// The range that the volume covers, up to half a voxel beyond the outer centres: limits for slices and slabs.
DepthRange depthsMm(const Volume& volume, const SlicePlane& plane);

// The smallest mmPerPixel at which the whole section of the volume fits the picture; for a plane that misses
// the volume, the whole volume. Positive; 1 if the plane is not usable or there are no pixels.
double fittedMmPerPixel(const Volume& volume, const SlicePlane& plane, const glm::ivec2& sizePx);

// The step from one slice to the next along the normal: the distance between voxel planes if the plane is
// parallel to them (to a thousandth of a radian), else the smallest side of a voxel. Positive.
double stepMm(const Volume& volume, const SlicePlane& plane);

}  // namespace macula::slices
