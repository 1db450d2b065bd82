// What a person draws on slices: lengths, angles, both axes of a lesion, values within an ellipse or an
// outline, and arrows with words. Points are in patient LPS mm, so a measurement does not depend on the view.
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

// Both axes of a lesion, as RECIST measures it: lines that cross at a right angle. The longer one is the long
// axis, whichever was drawn first.
struct Bidirectional {
    std::array<glm::dvec3, 2> firstMm{};
    std::array<glm::dvec3, 2> secondMm{};
    bool isNode = false;  // a person calls it a lymph node: its short axis counts in a follow-up
    bool operator==(const Bidirectional&) const = default;
};

struct CobbAngle {
    std::array<glm::dvec3, 4> pointsMm{};  // the ends of one line, then those of the other
    bool operator==(const CobbAngle&) const = default;
};

// Its words are the label.
struct Arrow {
    glm::dvec3 tipMm{0.0};
    glm::dvec3 tailMm{0.0};
    bool operator==(const Arrow&) const = default;
};

// Drawn by hand; from the last point it goes back to the first.
struct Outline {
    std::vector<glm::dvec3> pointsMm;
    bool operator==(const Outline&) const = default;
};

// Drawn by hand, with two ends.
struct OpenLine {
    std::vector<glm::dvec3> pointsMm;
    bool operator==(const OpenLine&) const = default;
};

struct Measurement {
    std::string label = {};  // a person's words; may be empty
    std::variant<Distance, Angle, Ellipse, Bidirectional, CobbAngle, Arrow, Outline, OpenLine> shape;
    // Normal of the plane that it was drawn on; slices that it lies in show it (liesIn). An ellipse uses the
    // normal of its own plane instead.
    glm::dvec3 normal{0.0, 0.0, 1.0};
    bool operator==(const Measurement&) const = default;
};

// The name in files: "distance", "angle", "ellipse", "bidirectional", "cobb angle", "arrow", "outline",
// "line".
std::string_view kindOf(const Measurement& measurement);
// The points that define it: both ends; leg, vertex, leg; the centre and the ends of both radii; the ends of
// both lines; tip and tail; or all points in order.
std::vector<glm::dvec3> pointsOf(const Measurement& measurement);

// NaN if a point, or a radius of an area, is not finite; so are the next ones.
double lengthMm(const Distance& distance);
double lengthMm(const OpenLine& line);  // along it; NaN for fewer than two points
// 0 to 180. NaN when a leg has no length.
double angleDeg(const Angle& angle);
// Between the lines, whichever way they were drawn: 0 to 90. NaN when a line has no length.
double angleDeg(const CobbAngle& angle);
double areaMm2(const Ellipse& ellipse);  // of the shape as drawn, even without a voxel
// NaN for fewer than three points, and for an outline that crosses itself: it has no inside.
double areaMm2(const Outline& outline);

struct Axes {
    double longMm = 0.0;   // NaN if a point is not finite; so is the other
    double shortMm = 0.0;  // not longer
};
Axes axesOf(const Bidirectional& lesion);

struct AreaValues {
    double areaMm2 = 0.0;          // of the shape
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
std::optional<AreaValues> valuesIn(const Ellipse& ellipse, const Volume& volume);
// Likewise for an outline in the plane through its first point with that normal. One without any such voxel
// has the value of the voxel around its centroid, if that lies within it. Nothing without an area.
std::optional<AreaValues> valuesIn(const Outline& outline, const glm::dvec3& normal, const Volume& volume);
// Of the ellipse or outline that it is; nothing for other shapes.
std::optional<AreaValues> valuesIn(const Measurement& measurement, const Volume& volume);

// Whether the whole measurement is within `toleranceMm` of `plane`, and was drawn on a plane parallel to it,
// to a degree.
bool liesIn(const Measurement& measurement, const SlicePlane& plane, double toleranceMm);

// The slice of the volume in whose thickness the whole measurement lies; nothing if it crosses several, or
// lies outside the volume.
std::optional<int> sliceOf(const Measurement& measurement, const Volume& volume);

// Whether it has a length or an area: all but angles and arrows do.
bool hasSize(const Measurement& measurement);
// Whether it has an area, and values within it.
bool hasArea(const Measurement& measurement);

// The text beside it: "12.3 mm", "45.0°", "120 ± 14 HU, min 35, max 160, 310 mm²", "42.1 × 18.0 mm" with the
// long axis first; "–" if a value is not defined; nothing for an arrow. Lengths and areas begin with "≈" if
// the volume is not calibrated. The unit is Volume::unitName. HU are whole numbers; others have three digits
// or more. As slow as valuesIn: drawing code caches it.
std::string textOf(const Measurement& measurement, const Volume& volume);

}  // namespace macula::slices
