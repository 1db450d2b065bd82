// Edits of a transfer function by hand: they move, add, remove or recolour a point, and shift, widen or scale
// all of it. Pure functions.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

#include "pipeline/volume/transfer_function.h"

namespace macula::scene {

// Values are the preset's own, before a fit to the volume (value_axis.h). A valid function (validate) with
// values within presets::kLargestValue either way and at most presets::kMostPoints points per curve stays so.
// A number that is not finite changes nothing. An index must be that of a point.

// Clamps the value to those of the neighbouring points, the opacity to 0 to 1. Two points at one value are a
// step.
TransferFunction movedOpacityPoint(TransferFunction function, std::size_t index, double value,
                                   double opacity);
TransferFunction movedColourPoint(TransferFunction function, std::size_t index, double value);
// `colour` is sRGB-encoded, and clamped to 0 to 1.
TransferFunction recoloured(TransferFunction function, std::size_t index, const glm::dvec3& colour);

struct Added {
    TransferFunction function;
    std::optional<std::size_t> index = {};  // index of the new point; nothing: no room, or not finite
};
// A curved piece that gets a new point becomes two straight ones. A point on a straight piece does not change
// the picture.
Added withOpacityPoint(TransferFunction function, double value, double opacity);
Added withColourPoint(TransferFunction function, double value, const glm::dvec3& colour);
// A curve keeps its only point.
TransferFunction withoutOpacityPoint(TransferFunction function, std::size_t index);
TransferFunction withoutColourPoint(TransferFunction function, std::size_t index);

// Gives steep matter its own curves, copies of those of all matter, so that no picture changes. Keeps
// existing ones.
TransferFunction withSteepCurves(TransferFunction function);
TransferFunction withoutSteepCurves(TransferFunction function);

// Moves all curves by `by` towards larger values, and the effective range with them, unless the preset is
// fitted by it. Stops at presets::kLargestValue.
TransferFunction shifted(TransferFunction function, double by);
// Maps value to about + factor * (value - about), and scales gradients too, as a fit does. The factor is
// above 0, and clamped where the curves would get narrower than kNarrowestCurve or leave the range of values.
inline constexpr double kNarrowestCurve = 1e-6;
TransferFunction widened(TransferFunction function, double factor, double about);

// Limits in files for gradients of surfaces and of steep matter, in units of the curve per mm.
inline constexpr double kLeastGradientPerMm = 1e-6;
inline constexpr double kMostGradientPerMm = 1e6;

// Multiplies all opacities by a factor of 0 or above, and clamps them to 1.
TransferFunction withOpacityScaled(TransferFunction function, double factor);

}  // namespace macula::scene
