// Lists of numbers as text (the VR DS of PS3.5 6.2), and as programs write them that do not know how.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

struct NumberList {
    std::optional<std::vector<double>> values;
    bool isRepaired = false;   // not written as the standard asks: read in the only way that there is
    bool isMalformed = false;  // there is text, and none or more than one way to read it
};

// Exactly `count` numbers, with a point or a comma before the decimals, and backslashes, commas, semicolons
// or blanks between them. Of text that is not as it should be, all ways to read it must agree: "0.7,0.7",
// "0,7\0,7", "0,7 0,7" and "0,7,0,7" are two numbers each; "1,5" is one or two, and "1,250\1,250" may be
// thousands.
NumberList numberListOf(std::string_view text, std::size_t count);

// Of an element; as Dataset::numbers where it is as it should be.
NumberList numberList(const Dataset& dataset, Tag tag, std::size_t count);

}  // namespace macula::dicom
