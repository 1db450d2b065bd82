// What a person measures on slices: distances, angles, and values within an ellipse. Points are in patient
// LPS mm, so a measurement is the same whatever it is looked at with.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>

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
    // The plane that it was drawn on: it is shown on slices that it lies in.
    glm::dvec3 normal{0.0, 0.0, 1.0};
    bool operator==(const Measurement&) const = default;
};

double lengthMm(const Distance& distance);
// 0 to 180. NaN when a leg has no length.
double angleDeg(const Angle& angle);

struct EllipseValues {
    double areaMm2 = 0.0;
    std::size_t voxels = 0;  // that the rest is over: those whose middle is nearest to a sample of the plane
    double mean = 0.0;       // in units, as the three below
    double deviation = 0.0;  // of a sample: n - 1
    double low = 0.0;
    double high = 0.0;
};
// Over the voxels that the ellipse cuts, each once; padding left out. Nothing where there is none.
std::optional<EllipseValues> valuesIn(const Ellipse& ellipse, const Volume& volume);

// All points within `toleranceMm` of the plane of the frame, and drawn on one parallel to it.
bool liesIn(const Measurement& measurement, const SlicePlane& plane, double toleranceMm);

// What is written beside it: "12.3 mm", "45.0°", "120 ± 14 HU, 35 to 160, 310 mm²". `unit` is
// Volume::unitName.
std::string textOf(const Measurement& measurement, const Volume& volume);

}  // namespace macula::slices
