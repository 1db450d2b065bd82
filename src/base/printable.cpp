#include "base/printable.h"

namespace macula {

namespace {

// The length in bytes of the control of direction or line separator with which the text begins; 0 for
// anything else.
std::size_t bytesOfControl(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (text.size() >= 2 && byte(0) == 0xd8 && byte(1) == 0x9c) return 2;
    if (text.size() < 3 || byte(0) != 0xe2) return 0;
    const unsigned char last = byte(2);
    const bool isMarkOrLine =
        byte(1) == 0x80 && (last == 0x8e || last == 0x8f || (last >= 0xa8 && last <= 0xae));
    const bool isIsolate = byte(1) == 0x81 && last >= 0xa6 && last <= 0xa9;
    return isMarkOrLine || isIsolate ? 3 : 0;
}

}  // namespace

std::string unmixed(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t control = bytesOfControl(text);
        result += control > 0 ? '?' : text.front();
        text.remove_prefix(control > 0 ? control : 1);
    }
    return result;
}

std::string printable(const std::string& given) {
    const std::string text = unmixed(given);
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
