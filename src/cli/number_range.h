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

}  // namespace macula::cli
