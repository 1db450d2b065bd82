// Options whose values are names.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <map>
#include <string>

namespace macula::cli {

// Takes one of the names, and gives its number.
CLI::Validator oneOf(std::map<std::string, int> numbersByName);

// For an option of type ViewDirection, or several: names become values, and for others there is a sentence.
CLI::Validator asViewDirection();

// For an option of type trace::Filter: a name becomes the value.
CLI::Validator asFilter();
inline constexpr const char* kFilterNames = "trilinear|stochastic|smooth|sharp";

// For an option of type trace::ToneMap, likewise.
CLI::Validator asToneMap();
inline constexpr const char* kToneMapNames = "neutral|hue";

// "anterior|posterior|...", for help.
inline constexpr const char* kViewDirectionNames =
    "anterior|posterior|left|right|superior|inferior|oblique|three-quarter|turned";

}  // namespace macula::cli
