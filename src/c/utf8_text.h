// Text for a host is UTF-8, whatever a path or an argument held.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace macula::c {

// The same text, with U+FFFD for each byte that is not part of a character.
std::string utf8Of(std::string_view text);

// In English, the language of the C interface.
std::vector<std::string> inEnglish(const std::vector<Text>& texts);

}  // namespace macula::c
