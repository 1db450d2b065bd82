// Curves as VTK's programs write and keep them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::presets {

constexpr std::size_t kMostPoints = 4096;
constexpr double kLargestValue = 1e9;  // of x, either way

// "N x y x y …": N is how many numbers follow. Points have to be sorted; of two at the same value that differ
// the second is moved up by the least possible, as 3D Slicer does, so that the first still holds there.
// Heights are clamped to 0 and 1, and `clamped` set where that changed one. `what` is what to call the curve
// in an error, `where` its file.
Result<std::vector<OpacityPoint>> opacityFromText(std::string_view text, const Text& what,
                                                  const std::string& where, bool& clamped);
// "N x r g b x r g b …"
Result<std::vector<ColourPoint>> colourFromText(std::string_view text, const Text& what,
                                                const std::string& where, bool& clamped);

// Sorts points that were added in any order, as VTK does with those of all other formats. `keepSteps` says
// what becomes of several at one value: true keeps all, each moved as above, false keeps the last.
void sortAsAdded(std::vector<OpacityPoint>& points, bool keepSteps);
void sortAsAdded(std::vector<ColourPoint>& points, bool keepSteps);

}  // namespace macula::presets
