// Measurements on slices: distances, angles, and values within an ellipse. Points are in patient LPS mm, so a
// measurement does not depend on the view.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/volume.h"
#include "slices/slice_plane.h"

namespace macula::slices {

struct Distance {
    std::array<glm::dvec3, 2> endsMm{};
    bool operator==(const Distance&) const = default;
};

struct Angle {
    std::array<glm::dvec3, 3> pointsMm{};  // the vertex is the second
    bool operator==(const Angle&) const = default;
};

// Its axes run along right and down of the plane.
struct Ellipse {
    SlicePlane plane;  // its centre is the ellipse's
    glm::dvec2 radiiMm{0.0};
    bool operator==(const Ellipse&) const = default;
};

struct Measurement {
    std::string label = {};  // a person's words; may be empty
    std::variant<Distance, Angle, Ellipse> shape;
    // Normal of the plane that it was drawn on; slices that it lies in show it (liesIn). An ellipse uses the
    // normal of its own plane instead.
    glm::dvec3 normal{0.0, 0.0, 1.0};
    bool operator==(const Measurement&) const = default;
};

// The name in files: "distance", "angle", "ellipse".
std::string_view kindOf(const Measurement& measurement);
// The points that define it: both ends; leg, vertex, leg; or the centre and the ends of both radii.
std::vector<glm::dvec3> pointsOf(const Measurement& measurement);

// NaN if a point, or a radius of an area, is not finite; so are the next two.
double lengthMm(const Distance& distance);
// 0 to 180. NaN when a leg has no length.
double angleDeg(const Angle& angle);
double areaMm2(const Ellipse& ellipse);  // of the shape as drawn, even without a voxel

struct EllipseValues {
    double areaMm2 = 0.0;          // areaMm2(ellipse)
    std::size_t voxels = 0;        // how many the values below are taken from
    std::size_t interpolated = 0;  // how many of them are in slices without an image
    double mean = 0.0;             // in the volume's unit, like the next three
    double deviation = 0.0;        // of a sample (n - 1); NaN for one voxel
    double low = 0.0;
    double high = 0.0;
};
// Measures each voxel, except padding, that the plane cuts so that the centroid of the cut lies in or on the
// ellipse; in a plane of voxels these are the voxels whose centre does. The voxel at the ellipse's centre
// always counts, so that a small ellipse has a value. A plane half way between two slices belongs to the one
// with the larger index. Ignores a slab: the plane alone counts. Nothing if no voxel is left, or a radius is
// not above 0 or is NaN.
std::optional<EllipseValues> valuesIn(const Ellipse& ellipse, const Volume& volume);

// Whether the whole measurement is within `toleranceMm` of `plane`, and was drawn on a plane parallel to it,
// to a degree.
bool liesIn(const Measurement& measurement, const SlicePlane& plane, double toleranceMm);

// The slice of the volume in whose thickness the whole measurement lies; nothing if it crosses several, or
// lies outside the volume.
std::optional<int> sliceOf(const Measurement& measurement, const Volume& volume);

// Whether it has a length or an area: all but angles do.
bool hasSize(const Measurement& measurement);

// The text beside it: "12.3 mm", "45.0°", "120 ± 14 HU, min 35, max 160, 310 mm²"; "–" if a value is not
// defined. Lengths and areas begin with "≈" if the volume is not calibrated. The unit is Volume::unitName. HU
// are whole numbers; others have three digits or more. As slow as valuesIn: drawing code caches it.
std::string textOf(const Measurement& measurement, const Volume& volume);

}  // namespace macula::slices
