// Text that leaves for a host is UTF-8, whatever a path or an argument held.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace macula::c {

// The same, with U+FFFD for each byte that belongs to no letter.
std::string utf8Of(std::string_view text);

// In English, which is what a host is told.
std::vector<std::string> inEnglish(const std::vector<Text>& texts);

}  // namespace macula::c
