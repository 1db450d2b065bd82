// Parses lists of numbers as text (the VR DS of PS3.5 6.2), also those that programs write wrongly.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

struct NumberList {
    std::optional<std::vector<double>> values;
    bool isRepaired = false;   // not as the standard asks, but readable in only one way
    bool isMalformed = false;  // there is text, but no way or several ways to read it
};

// Exactly `count` numbers, with a point or a comma before the decimals, and backslashes, commas, semicolons
// or blanks between them. All ways to read malformed text must agree: "0.7,0.7", "0,7\0,7", "0,7 0,7" and
// "0,7,0,7" are two numbers each; "1,5" is one or two, and "1,250\1,250" may be thousands.
NumberList numberListOf(std::string_view text, std::size_t count);

// The list of an element; as Dataset::numbers when it is well-formed.
NumberList numberList(const Dataset& dataset, Tag tag, std::size_t count);

}  // namespace macula::dicom
