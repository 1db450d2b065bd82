// A transfer function, edited by hand: a point moved, added, removed or recoloured, and all of it shifted,
// widened or scaled. Pure functions.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

#include "pipeline/volume/transfer_function.h"

namespace macula::app {

// Values are the preset's own, before a fit to the volume (value_axis.h). What is returned is valid
// (validate) where what was given is, with all values within presets::kLargestValue either way, and at most
// presets::kMostPoints points in a curve. A number that is not finite changes nothing. An index must be that
// of a point.

// Not beyond the points beside it; the opacity within 0 to 1. At the value of another one it is a step.
TransferFunction movedOpacityPoint(TransferFunction function, std::size_t index, double value,
                                   double opacity);
TransferFunction movedColourPoint(TransferFunction function, std::size_t index, double value);
// sRGB-encoded; brought into 0 to 1.
TransferFunction recoloured(TransferFunction function, std::size_t index, const glm::dvec3& colour);

struct Added {
    TransferFunction function;
    std::optional<std::size_t> index = {};  // of the new point; nothing: there is no room, or no number
};
// A curved piece that the point falls into becomes two straight ones. A point on a straight piece changes no
// picture.
Added withOpacityPoint(TransferFunction function, double value, double opacity);
Added withColourPoint(TransferFunction function, double value, const glm::dvec3& colour);
// The last point of a curve stays.
TransferFunction withoutOpacityPoint(TransferFunction function, std::size_t index);
TransferFunction withoutColourPoint(TransferFunction function, std::size_t index);

// Steep matter gets curves of its own, which begin as those of all matter: no picture changes. Where it has
// some, they stay.
TransferFunction withSteepCurves(TransferFunction function);
TransferFunction withoutSteepCurves(TransferFunction function);

// All curves move by so much towards larger values, and the effective range with them, unless that is what
// the preset is fitted by.
TransferFunction shifted(TransferFunction function, double by);
// The same with value' = about + factor * (value - about); gradients are stretched with them, as by a fit.
// The factor is above 0, and is held where the curves would get narrower than kNarrowestCurve or leave the
// range of values.
inline constexpr double kNarrowestCurve = 1e-6;
TransferFunction widened(TransferFunction function, double factor, double about);

// Of surfaces and of steep matter, in units of the curve per mm: what files hold.
inline constexpr double kLeastGradientPerMm = 1e-6;
inline constexpr double kMostGradientPerMm = 1e6;

// All opacities times a factor of 0 or above, at most 1.
TransferFunction withOpacityScaled(TransferFunction function, double factor);

}  // namespace macula::app
