// Text that leaves for a host is UTF-8, whatever a path or an argument held.
#pragma once

#include <string>
#include <string_view>

namespace macula::c {

// The same, with U+FFFD for each byte that belongs to no letter.
std::string utf8Of(std::string_view text);

}  // namespace macula::c
