// Text for a host is UTF-8, whatever a path or an argument held.
#pragma once

#include <string>
#include <string_view>

namespace macula::c {

// The same text, with U+FFFD for each byte that is not part of a character.
std::string utf8Of(std::string_view text);

}  // namespace macula::c
