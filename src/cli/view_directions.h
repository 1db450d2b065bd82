// The directions that a patient is looked at from, as a person types them.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <string>

#include "base/frames.h"

namespace macula::cli {

// For an option of type ViewDirection, or several: names become values, and for others there is a sentence.
CLI::Validator asViewDirection();

std::string nameOf(ViewDirection direction);

// "anterior|posterior|...", for help.
inline constexpr const char* kViewDirectionNames = "anterior|posterior|left|right|superior|inferior";

}  // namespace macula::cli
