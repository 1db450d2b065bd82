// Reads curves in the formats of programs that use VTK.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::presets {

// All numbers of a text, separated by spaces, as other programs write them: with a decimal point, whatever
// the locale, and finite. Nothing if one of them is invalid, or there are more than `most`.
std::optional<std::vector<double>> numbersFrom(std::string_view text, std::size_t most);

constexpr std::size_t kMostPoints = 4096;
constexpr double kLargestValue = 1e9;  // the largest |x|

// "N x y x y …": N is the count of the numbers that follow. Points must be sorted; of two different points at
// the same value the second moves to the next larger value, as in 3D Slicer, so that the first still holds
// there. Heights are clamped to 0 and 1, and `clamped` is set if that changed one. `what` names the curve in
// an error, `where` its file.
Result<std::vector<OpacityPoint>> opacityFromText(std::string_view text, const Text& what,
                                                  const std::string& where, bool& clamped);
// "N x r g b x r g b …"
Result<std::vector<ColourPoint>> colourFromText(std::string_view text, const Text& what,
                                                const std::string& where, bool& clamped);

// Sorts points that were added in any order, as VTK does with those of all other formats. Of several points
// at one value, `keepSteps` keeps all, moved as above; otherwise only the last stays.
void sortAsAdded(std::vector<OpacityPoint>& points, bool keepSteps);
void sortAsAdded(std::vector<ColourPoint>& points, bool keepSteps);

}  // namespace macula::presets
