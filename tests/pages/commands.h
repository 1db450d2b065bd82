// Whether a command line that a page shows is one that `macula` understands. Nothing of it is done: it is
// held to what the built command says of itself.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace macula::test {

// The words of a line that calls `macula`, from the verb on: without the program, a comment behind #, and the
// brackets around what may be left out. Empty for any other line.
std::vector<std::string> maculaWords(std::string_view line);

// What may follow these words, by the help of `macula`.
const std::set<std::string>& verbsBehind(const std::vector<std::string>& verb);

// Why `macula` would refuse these words, or nothing: a verb or option that it does not have, a choice that
// is not among the option's, a preset, light, clip or quality that is not built in. Words in capitals, files
// and
// ... stand for what the reader puts there. `isWhole`: the options that the verb requires have to be there
// too.
std::string whyRefused(const std::vector<std::string>& words, bool isWhole);

}  // namespace macula::test
