// Numbers as files of other programs write them: with a point, whatever the locale, and finite.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace macula::presets {

// All numbers of a text in which they stand between spaces. Nothing when one of them is none, or there are
// more than `most`.
std::optional<std::vector<double>> numbersFrom(std::string_view text, std::size_t most);

}  // namespace macula::presets
