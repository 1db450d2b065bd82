// Text in UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace macula {

// The length in bytes of the first character; 0 if the text is empty, or the character is malformed:
// overlong, a surrogate, above U+10FFFF, or cut off.
constexpr std::size_t firstCharacterBytes(std::string_view text) {
    const auto byteAt = [&](std::size_t at) {
        return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u;
    };
    const unsigned first = byteAt(0);
    if (text.empty()) return 0;
    if (first < 0x80) return 1;
    if (first < 0xc2 || first > 0xf4) return 0;
    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    for (std::size_t at = 1; at < bytes; ++at)
        if ((byteAt(at) & 0xc0u) != 0x80u) return 0;
    const unsigned second = byteAt(1);
    const bool isOverlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool isNone = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
    return isOverlong || isNone ? 0 : bytes;
}

constexpr bool isValidUtf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t bytes = firstCharacterBytes(text);
        if (bytes == 0) return false;
        text.remove_prefix(bytes);
    }
    return true;
}

// The longest prefix of a UTF-8 text that has at most `mostBytes` bytes and ends with a whole character.
constexpr std::string_view startOf(std::string_view text, std::size_t mostBytes) {
    if (text.size() <= mostBytes) return text;
    while (mostBytes > 0 && (static_cast<unsigned char>(text[mostBytes]) & 0xc0u) == 0x80u) --mostBytes;
    return text.substr(0, mostBytes);
}

}  // namespace macula
