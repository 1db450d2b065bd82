#include "c/utf8_text.h"

#include <cstddef>

namespace macula::c {

namespace {

unsigned byteAt(std::string_view text, std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u;
}

// How many bytes of the first letter are there; 0 where they are none: overlong, a surrogate, or cut off.
std::size_t letterBytes(std::string_view text) {
    const unsigned first = byteAt(text, 0);
    if (first < 0x80) return 1;
    const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4) return 0;
    for (std::size_t at = 1; at < bytes; ++at)
        if ((byteAt(text, at) & 0xC0) != 0x80) return 0;
    const unsigned second = byteAt(text, 1);
    const bool isOverlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool isNoLetter = (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
    return isOverlong || isNoLetter ? 0 : bytes;
}

}  // namespace

std::string utf8Of(std::string_view text) {
    std::string utf8;
    utf8.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = letterBytes(text);
        utf8 += bytes == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(0, bytes);
        text.remove_prefix(bytes == 0 ? 1 : bytes);
    }
    return utf8;
}

}  // namespace macula::c
