// Text as people search it: "muller" finds "MÜLLER".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace macula::app {

// UTF-8 in lower case and without diacritics, for Latin, Greek and Cyrillic letters; wide Latin letters and
// blanks are plain ones. All else is kept, bytes that are no UTF-8 too.
std::string foldedForSearch(std::string_view utf8);

// The words of what was typed, folded; blanks, commas, ^ and = separate them, as they do parts of names.
std::vector<std::string> searchWords(std::string_view typed);

// Whether each of `words` is somewhere in a text that was folded; true without words.
bool holdsAll(std::string_view folded, const std::vector<std::string>& words);

}  // namespace macula::app
