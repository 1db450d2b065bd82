#include "dicom/read/number_list.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/parsing.h"

namespace macula::dicom {

namespace {

using Values = std::vector<double>;

// Splits text at separators. Several in a row count as one, except commas and backslashes: an empty part
// between these is a missing number.
std::vector<std::string> partsOf(std::string_view text, std::string_view separators) {
    constexpr std::string_view kBlanks = " \t\r\n";
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (separators.find(c) != std::string_view::npos) {
            const bool ofBlanks = kBlanks.find(c) != std::string_view::npos;
            if (!ofBlanks || !parts.back().empty()) parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    for (std::string& part : parts) part = std::string(trimmed(part));
    if (parts.size() > 1 && parts.back().empty()) parts.pop_back();
    return parts;
}

// "1,250" and "-10,000": the comma may stand before decimals, or between thousands.
bool mayBeThousands(std::string_view part) {
    const std::size_t comma = part.find(',');
    if (comma == std::string_view::npos) return false;
    constexpr std::size_t kDigits = 3;
    const std::string_view before = part.substr(0, comma);
    const std::string_view whole = before.substr(std::min(before.find_first_of("0123456789"), before.size()));
    return part.size() - comma - 1 == kDigits && !whole.empty() && whole != "0" && whole.size() <= kDigits;
}

std::optional<Values> valuesOf(std::vector<std::string> parts, std::size_t count, bool decimalCommas) {
    if (parts.size() != count) return {};
    Values values;
    for (std::string& part : parts) {
        if (decimalCommas) {
            if (mayBeThousands(part) || part.find('.') != std::string::npos) return {};
            if (const std::size_t comma = part.find(','); comma != std::string::npos) part[comma] = '.';
        }
        const auto value = finiteNumber(part);
        if (!value) return {};
        values.push_back(*value);
    }
    return values;
}

// "0,7,0,7": each second comma stands before decimals.
std::optional<Values> valuesOfPairs(std::string_view text, std::size_t count) {
    const std::vector<std::string> parts = partsOf(text, ",");
    if (parts.size() != 2 * count) return {};
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < parts.size(); i += 2) {
        const bool areDigits = !parts[i + 1].empty() &&
                               std::ranges::all_of(parts[i + 1], [](char c) { return c >= '0' && c <= '9'; });
        if (!areDigits) return {};
        numbers.push_back(parts[i] + "," + parts[i + 1]);
    }
    return valuesOf(std::move(numbers), count, true);
}

// A list of two without a point, "1,5", may as well be one number.
bool mayBeOneNumber(std::string_view text, std::size_t count) {
    return count == 2 && text.find_first_of("\\; \t.") == std::string_view::npos;
}

}  // namespace

NumberList numberListOf(std::string_view text, std::size_t count) {
    text = trimmed(text);
    if (text.empty()) return {};
    if (auto values = valuesOf(partsOf(text, "\\"), count, false)) return {.values = std::move(values)};
    std::vector<Values> readings;
    const auto add = [&](std::optional<Values> values) {
        if (values && std::ranges::find(readings, *values) == readings.end())
            readings.push_back(*std::move(values));
    };
    if (!mayBeOneNumber(text, count)) add(valuesOf(partsOf(text, ","), count, false));
    for (const std::string_view separators : {"\\", ";", " \t\r\n"}) {
        add(valuesOf(partsOf(text, separators), count, true));
        add(valuesOf(partsOf(text, separators), count, false));
    }
    add(valuesOfPairs(text, count));
    if (readings.size() != 1) return {.isMalformed = true};
    return {.values = std::move(readings.front()), .isRepaired = true};
}

NumberList numberList(const Dataset& dataset, Tag tag, std::size_t count) {
    if (auto values = dataset.numbers(tag, count)) return {.values = std::move(values)};
    constexpr std::size_t kLongest = 512;
    const auto text = dataset.text(tag);
    if (!text || text->size() > kLongest) return {.isMalformed = text.has_value()};
    return numberListOf(*text, count);
}

}  // namespace macula::dicom
