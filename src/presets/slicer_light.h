// Reads lighting and interpolation of a 3D Slicer volume property from text.
#pragma once

#include <optional>
#include <string_view>

#include "pipeline/volume/transfer_function.h"

namespace macula::presets {

// Returns whether `text` is a number from 0 to `most`, and sets `out` to it.
bool readLight(std::string_view text, double most, double& out);

// "0" nearest, "1" linear, "2" cubic.
std::optional<Interpolation> interpolationFrom(std::string_view text);

}  // namespace macula::presets
