// Computes how slices make a volume from where they lie in the patient (PS3.3 C.7.6.2, Image Plane Module).
// All positions and distances are in mm, patient LPS. Pure functions.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/frames.h"
#include "dicom/messages/messages.h"

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

// Planes at most this far apart along the normal are at one position.
inline constexpr double kSamePositionMm = 1e-3;

// Whether the two directions are unit vectors, perpendicular to each other, within 0.001, and position and
// spacings are plausible for a patient.
bool isUsable(const ImagePlane& plane);

struct StackedPlane {
    ImagePlane plane;
    int instanceNumber = 0;  // orders planes at equal positions
};

// A slice of the volume: (1 - weight) * plane[below] + weight * plane[above], both places in
// StackGeometry::order.
struct SliceSource {
    std::size_t below = 0;
    std::size_t above = 0;
    double weight = 0.0;

    bool interpolated() const { return below != above; }
    bool operator==(const SliceSource&) const = default;
};

struct StackGeometry {
    enum class Quality {
        none,       // no volume; `messages` say why
        resampled,  // slices are missing or unevenly spaced: some of `slices` are interpolated
        even,       // every plane is a slice, and every slice a plane
    };

    Quality quality = Quality::none;
    // Indices of the planes given, ascending along the normal of the first.
    std::vector<std::size_t> order;
    std::vector<SliceSource> slices;           // of the volume, ascending
    std::optional<glm::dmat4> worldFromVoxel;  // set unless quality is none
    // Largest distance of a plane that is a slice from its place by worldFromVoxel.
    double largestErrorMm = 0.0;
    std::vector<Message> messages;
};

// Sorts planes by their position along the normal, equal positions by instance number, then in the order
// given. The slice axis of worldFromVoxel goes from the first position to the last, so that a tilted gantry's
// sheared stack stays sheared; SliceThickness is ignored. Missing slices (a distance that is a multiple of
// the usual one) become interpolated ones between planes that are kept as they are; other uneven distances
// are resampled to the smallest. There is no volume when more slices would be interpolated than there are
// planes, when planes are at one position, not parallel, or not in line.
StackGeometry stackPlanes(std::span<const StackedPlane> planes);

}  // namespace macula::dicom
