#include "c/utf8_text.h"

#include <cstddef>

#include "base/utf8.h"

namespace macula::c {

std::string utf8Of(std::string_view text) {
    std::string utf8;
    utf8.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = firstCharacterBytes(text);
        utf8 += bytes == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(0, bytes);
        text.remove_prefix(bytes == 0 ? 1 : bytes);
    }
    return utf8;
}

}  // namespace macula::c
