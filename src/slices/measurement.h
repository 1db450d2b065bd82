// What a person measures on slices: distances, angles, and values within an ellipse. Points are in patient
// LPS mm, so a measurement is the same whatever it is looked at with.
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

// In the plane: axes along right and down.
struct Ellipse {
    SlicePlane plane;  // its centre is the ellipse's
    glm::dvec2 radiiMm{0.0};
    bool operator==(const Ellipse&) const = default;
};

struct Measurement {
    std::string label = {};  // a person's words; may be empty
    std::variant<Distance, Angle, Ellipse> shape;
    // The plane that it was drawn on: it is shown on slices that it lies in. Of an ellipse that of its own
    // plane counts.
    glm::dvec3 normal{0.0, 0.0, 1.0};
    bool operator==(const Measurement&) const = default;
};

// As in files: "distance", "angle", "ellipse".
std::string_view kindOf(const Measurement& measurement);
// That it was drawn by: ends; legs with the vertex between them; centre, and the ends of both radii.
std::vector<glm::dvec3> pointsOf(const Measurement& measurement);

// NaN where a point is not finite, as are the two below.
double lengthMm(const Distance& distance);
// 0 to 180. NaN when a leg has no length.
double angleDeg(const Angle& angle);
double areaMm2(const Ellipse& ellipse);  // as it was drawn, also where there is no voxel

struct EllipseValues {
    double areaMm2 = 0.0;          // as above
    std::size_t voxels = 0;        // that the rest is over
    std::size_t interpolated = 0;  // of these, in slices in which no image was taken
    double mean = 0.0;             // in units, as the three below
    double deviation = 0.0;        // of a sample: n - 1. NaN of one voxel
    double low = 0.0;
    double high = 0.0;
};
// Over voxels, each once, padding left out: those that the plane cuts, and cuts so that the middle of the cut
// lies in the ellipse or on it. Where the plane is one of voxels, these are the voxels whose centre lies in
// the ellipse. The voxel at the ellipse's centre always counts, so that a small one has a value. A plane half
// way between two slices is in the one of the larger index. A slab does not count: it is the plane alone.
// Nothing where no voxel is left, and for what is no ellipse: radii that are not above 0, or NaN.
std::optional<EllipseValues> valuesIn(const Ellipse& ellipse, const Volume& volume);

// All of it within `toleranceMm` of the plane of the frame, and drawn on one parallel to it, to a degree.
bool liesIn(const Measurement& measurement, const SlicePlane& plane, double toleranceMm);

// The slice of the volume in whose thickness all of it lies; nothing where it goes through several, or lies
// outside of the volume.
std::optional<int> sliceOf(const Measurement& measurement, const Volume& volume);

// Whether it says a length or an area: all but angles do.
bool hasSize(const Measurement& measurement);

// What is written beside it: "12.3 mm", "45.0°", "120 ± 14 HU, 35 to 160, 310 mm²"; "–" for what is not
// defined. Lengths and areas begin with "≈" where the volume is not calibrated. The unit is Volume::unitName.
// HU are whole numbers; others have three digits or more. As slow as valuesIn: for whoever draws to keep.
std::string textOf(const Measurement& measurement, const Volume& volume);

}  // namespace macula::slices
