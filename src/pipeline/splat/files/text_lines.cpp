#include "pipeline/splat/files/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "pipeline/splat/files/chunk_file.h"

namespace macula::splat {

namespace {

// The text after "NAME " in the only line that begins with it.
std::optional<std::string_view> valueOf(const std::vector<std::string>& lines, std::string_view name) {
    std::optional<std::string_view> value;
    for (const std::string_view line : lines) {
        if (!line.starts_with(name) || !line.substr(name.size()).starts_with(' ')) continue;
        if (value) return std::nullopt;
        value = line.substr(name.size() + 1);
    }
    return value;
}

// Parses the whole of `text` as a number.
template <class T>
bool parseWhole(std::string_view text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::string joinLines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

std::vector<std::string> splitLines(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::string exactText(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

Result<std::uint64_t> numberIn(const std::vector<std::string>& lines, std::string_view name,
                               std::uint64_t most) {
    const auto text = valueOf(lines, name);
    std::uint64_t value = 0;
    if (!text || !parseWhole(*text, value) || value > most) return damagedModel();
    return value;
}

Result<std::vector<double>> numbersIn(const std::vector<std::string>& lines, std::string_view name,
                                      std::size_t count) {
    const auto text = valueOf(lines, name);
    if (!text) return damagedModel();
    std::string_view left = *text;
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t end = std::min(left.find(' '), left.size());
        const bool isLast = end == left.size();
        if (!parseWhole(left.substr(0, end), values[i]) || !std::isfinite(values[i]) ||
            isLast != (i + 1 == count))
            return damagedModel();
        left.remove_prefix(isLast ? end : end + 1);
    }
    return values;
}

}  // namespace macula::splat
