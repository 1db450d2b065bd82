// Capitals with German umlauts, digits and marks of 5 by 7 dots.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace macula::xr {

// From the top; the bit of value 16 is the leftmost of five dots.
using LetterRows = std::array<std::uint8_t, 7>;

// A box for what has no letter.
const LetterRows& lettersOf(char32_t sign);

// Of UTF-8, one each, but two for a sharp s; what takes more than two bytes is one that has no letter.
std::u32string signsOf(std::string_view text);

}  // namespace macula::xr
