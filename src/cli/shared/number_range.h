// Numbers of the command line.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

namespace macula::cli {

// From `low` to `high`; what is no number ("nan"), and so neither below nor above them, is refused too.
inline CLI::Validator between(double low, double high) {
    const std::string range = fmt::format("{:g} to {:g}", low, high);
    const auto check = [low, high, range](const std::string& text) {
        double value = 0.0;
        const bool inside = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
        return inside ? std::string() : fmt::format("{} is no number from {}", text, range);
    };
    return {check, range, "number"};
}

// An option for a whole number, whose default is what `value` holds.
template <class Number>
void addNumber(CLI::App& command, const char* name, Number& value, const char* help, int low, int high) {
    command.add_option(name, value, help)->capture_default_str()->check(CLI::Range(low, high));
}

}  // namespace macula::cli
