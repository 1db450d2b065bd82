// Text from files and stores, for a terminal.
#pragma once

#include <string>

namespace macula {

// Text from elsewhere must not steer the terminal it is shown in: what could is '?' here. That is C0 and C1
// controls, the latter also as the UTF-8 pairs C2 80 to C2 9F, and as lone bytes.
std::string printable(const std::string& text);

}  // namespace macula
