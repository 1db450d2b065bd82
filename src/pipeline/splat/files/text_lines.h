// The text of .macula chunks and of PLY comments: each line holds a name, a space, and a value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace macula::splat {

// Each with its line feed; and back, where the last one may lack it.
std::string joinLines(const std::vector<std::string>& lines);
std::vector<std::string> splitLines(std::string_view text);

// The shortest text that reads back to the same bits.
std::string exactText(double value);

// The number behind "NAME " in the only line that begins so. Fails with inputNotUsable when there is none, or
// several, or it is above `most`.
Result<std::uint64_t> numberIn(const std::vector<std::string>& lines, std::string_view name,
                               std::uint64_t most);
// Likewise exactly `count` numbers, finite, with a space between two.
Result<std::vector<double>> numbersIn(const std::vector<std::string>& lines, std::string_view name,
                                      std::size_t count);

}  // namespace macula::splat
