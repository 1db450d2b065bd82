#include "presets/slicer_light.h"

#include "base/parsing.h"

namespace macula::presets {

bool readLight(std::string_view text, double most, double& out) {
    const std::optional<double> number = finiteNumber(text);
    if (!number || *number < 0.0 || *number > most) return false;
    out = *number;
    return true;
}

std::optional<Interpolation> interpolationFrom(std::string_view text) {
    const std::optional<double> number = finiteNumber(text);
    if (!number) return std::nullopt;
    if (*number == 0.0) return Interpolation::nearest;
    if (*number == 1.0) return Interpolation::linear;
    if (*number == 2.0) return Interpolation::cubic;
    return std::nullopt;
}

}  // namespace macula::presets
