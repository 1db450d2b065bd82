// Where slices lie in the patient, and whether they make a volume (PS3.3 C.7.6.2, Image Plane Module). All
// positions and distances in mm, patient LPS. Pure functions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/frames.h"
#include "dicom/messages.h"

namespace macula::dicom {

// One image plane.
struct ImagePlane {
    glm::dvec3 positionMm{0.0};  // ImagePositionPatient: centre of the first voxel
    glm::dvec3 rowDirection{
        1, 0, 0};  // ImageOrientationPatient[0..2]: the direction in which the column index grows
    glm::dvec3 columnDirection{
        0, 1, 0};  // ImageOrientationPatient[3..5]: the direction in which the row index grows
    double columnSpacingMm = 1.0;  // PixelSpacing[1]: between columns, along rowDirection
    double rowSpacingMm = 1.0;     // PixelSpacing[0]: between rows, along columnDirection

    glm::dvec3 normal() const { return glm::cross(rowDirection, columnDirection); }
};

// The two directions are unit vectors, perpendicular to each other, within 0.001; the spacings are positive.
bool isUsable(const ImagePlane& plane);

struct StackedPlane {
    ImagePlane plane;
    int instanceNumber = 0;  // orders planes at equal positions
};

struct Stack {
    std::vector<std::size_t> order;  // of the planes given, ascending along the normal of the first
    std::optional<glm::dmat4>
        worldFromVoxel;           // absent when the planes make no volume; `messages` then says why
    double largestErrorMm = 0.0;  // of any slice's true position against worldFromVoxel
    std::vector<Message> messages;
};

// Slices are sorted by their position along the normal, equal positions by instance number, then in the order
// given. worldFromVoxel is never right by accident: the slice axis is (last - first position) / (n - 1), so
// that a tilted gantry's sheared stack stays sheared, and SliceThickness plays no part. Planes that are not
// evenly spaced make no volume.
Stack stackPlanes(std::span<const StackedPlane> planes);

}  // namespace macula::dicom
