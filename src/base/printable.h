// Makes text from files and stores safe to show on a terminal and in labels.
#pragma once

#include <string>
#include <string_view>

namespace macula {

// Replaces with '?' every character that could control the terminal: C0 controls and DEL; C1 controls, both
// as the UTF-8 pairs C2 80 to C2 9F and as lone bytes; and the characters that unmixed replaces.
std::string printable(const std::string& text);

// Replaces with '?' each character that changes the direction of the text after it or ends its line
// (Unicode's U+061C, U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069): with one of these, a name, or a
// number next to it, could read as another. Text whose letters run from right to left stays as it is.
std::string unmixed(std::string_view text);

}  // namespace macula
