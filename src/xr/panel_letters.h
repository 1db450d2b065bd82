// Capitals with German umlauts, digits and marks of 5 by 7 dots.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace macula::xr {

// From the top; the bit of value 16 is the leftmost of five dots.
using LetterRows = std::array<std::uint8_t, 7>;

// The glyph of a character; a box if there is none.
const LetterRows& lettersOf(char32_t sign);

// The characters of UTF-8 text. A sharp s becomes two; a sequence of more than two bytes becomes one without
// a glyph.
std::u32string signsOf(std::string_view text);

}  // namespace macula::xr
