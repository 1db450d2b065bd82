// Reads numbers as other programs write them: with a decimal point, whatever the locale, and finite.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace macula::presets {

// All numbers of a text, separated by spaces. Nothing if one of them is invalid, or there are more than
// `most`.
std::optional<std::vector<double>> numbersFrom(std::string_view text, std::size_t most);

}  // namespace macula::presets
