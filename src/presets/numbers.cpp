#include "presets/numbers.h"

#include "base/parsing.h"

namespace macula::presets {

namespace {

constexpr std::string_view kSpace = " \t\r\n";

}  // namespace

std::optional<std::vector<double>> numbersFrom(std::string_view text, std::size_t most) {
    std::vector<double> numbers;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::string_view word = text.substr(0, text.find_first_of(kSpace));
        const std::optional<double> number = finiteNumber(word);
        if (!number || numbers.size() == most) return std::nullopt;
        numbers.push_back(*number);
        text.remove_prefix(word.size());
    }
    return numbers;
}

}  // namespace macula::presets
