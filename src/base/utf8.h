// Text in UTF-8.
#pragma once

#include <string_view>

namespace macula {

// The longest start of a text in UTF-8 that has at most so many bytes and ends with a whole character.
constexpr std::string_view startOf(std::string_view text, std::size_t mostBytes) {
    if (text.size() <= mostBytes) return text;
    while (mostBytes > 0 && (static_cast<unsigned char>(text[mostBytes]) & 0xc0u) == 0x80u) --mostBytes;
    return text.substr(0, mostBytes);
}

}  // namespace macula
