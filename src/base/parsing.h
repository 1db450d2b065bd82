// Parses text from files: numbers with a decimal point, whatever the locale.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace macula {

// The text without the padding on either side: blanks, line ends, and the NULs of DICOM.
constexpr std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kPadding{" \t\r\n\0", 5};
    const std::size_t begin = text.find_first_not_of(kPadding);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kPadding) - begin + 1);
}

// With the letters A to Z in lower case, whatever the locale.
inline std::string lowerCase(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

// Parses the whole of `text` as a number; nothing when it has padding or other characters.
template <class T>
std::optional<T> parseNumber(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return value;
}

// Parses `text` as a number, after it removes padding and a plus sign. Nothing for other text, infinity or
// NaN.
inline std::optional<double> finiteNumber(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto value = parseNumber<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace macula
