// Volumes of known shapes, sampled as a scanner would: a Gaussian blurs their edges, and there are no other
// artefacts. Voxels measure 1 mm along the patient's axes; volumes are centred on the patient's origin.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string_view>

#include "base/volume.h"

namespace macula::evaluate {

// Smooth bodies of water (40 HU) in air (-1000 HU), for an eye in front of the patient. None is aligned with
// planes of voxels: the plane is tilted by 8 and 5 degrees, the axis of the cylinder by 10.
enum class Shape { plane, cylinder, sphere };
inline constexpr std::array kShapes{Shape::plane, Shape::cylinder, Shape::sphere};
inline constexpr double kShapeRadiusMm = 24.0;  // of cylinder and sphere

// Fine detail that varies along the patient's x axis, 0 to 1000 without unit, 4 mm deep, constant along z.
enum class Detail {
    lines,    // 2 mm of 1000, 2 mm of 0, and so on
    fissure,  // a sheet of 300, 1 mm thick, in 100
    vessel,   // a cylinder of 1000, 1 mm thick, in 100
};
inline constexpr std::array kDetails{Detail::lines, Detail::fissure, Detail::vessel};
inline constexpr double kLinePeriodMm = 4.0;

std::string_view nameOf(Shape shape);
std::string_view nameOf(Detail detail);

// How far a point lies inside the shape, in mm; negative outside.
double depthIn(Shape shape, const glm::dvec3& worldMm);

Volume make(Shape shape);
Volume make(Detail detail);

}  // namespace macula::evaluate
