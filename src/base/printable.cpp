#include "base/printable.h"

namespace macula {

std::string printable(const std::string& text) {
    std::string result;
    int following = 0;  // bytes of a UTF-8 sequence still to come
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0u;
        const bool c1Pair = following == 0 && c == 0xc2 && next >= 0x80 && next < 0xa0;
        const bool stray = following == 0 && c >= 0x80 && c < 0xc2;
        if (c < 0x20 || c == 0x7f || c1Pair || stray) {
            result += '?';
            i += c1Pair ? 1 : 0;
            following = 0;
            continue;
        }
        result += text[i];
        following = c >= 0xf0 ? 3 : c >= 0xe0 ? 2 : c >= 0xc2 ? 1 : following > 0 ? following - 1 : 0;
    }
    return result;
}

}  // namespace macula
