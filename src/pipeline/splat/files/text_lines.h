// The text of .macula chunks and of PLY comments: each line holds a name, a space, and a value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace macula::splat {

// joinLines ends each line with a line feed; splitLines accepts a last line without one.
std::string joinLines(const std::vector<std::string>& lines);
std::vector<std::string> splitLines(std::string_view text);

// The shortest text that reads back to the same bits.
std::string exactText(double value);

// The number after "NAME " in the only line that begins with it. Fails with inputNotUsable when there is no
// such line, there are several, or the number is above `most`.
Result<std::uint64_t> numberIn(const std::vector<std::string>& lines, std::string_view name,
                               std::uint64_t most);
// The same for exactly `count` finite numbers, separated by single spaces.
Result<std::vector<double>> numbersIn(const std::vector<std::string>& lines, std::string_view name,
                                      std::size_t count);

}  // namespace macula::splat
