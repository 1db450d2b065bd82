// Text from files and stores, for a terminal and for labels.
#pragma once

#include <string>
#include <string_view>

namespace macula {

// Replaces with '?' all that could control the terminal which shows the text: C0 controls and DEL, C1
// controls, also as the UTF-8 pairs C2 80 to C2 9F and as lone bytes, and the characters that unmixed
// replaces.
std::string printable(const std::string& text);

// The text with '?' for each character that turns the direction of what follows or ends its line (Unicode's
// U+061C, U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069): with one of them a name, or a number beside
// it, reads as another. Text that runs from right to left by its letters stays as it is.
std::string unmixed(std::string_view text);

}  // namespace macula
