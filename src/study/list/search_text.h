// Folds text for search: "muller" finds "MÜLLER".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace macula::study {

// UTF-8 in lower case and without diacritics, for Latin, Greek and Cyrillic letters; full-width ASCII and
// spaces become plain. Keeps everything else, including bytes that are not UTF-8.
std::string foldedForSearch(std::string_view utf8);

// The folded words of `typed`; blanks, commas, ^ and = separate them, as in names of patients.
std::vector<std::string> searchWords(std::string_view typed);

// Whether the folded text contains each of `words`; true without words.
bool holdsAll(std::string_view folded, const std::vector<std::string>& words);

}  // namespace macula::study
