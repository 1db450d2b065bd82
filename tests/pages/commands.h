// Whether a command line that a page shows is one that `macula` or `macula-bench` understands. Nothing of it
// is done: it is held to what the built commands say of themselves.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace macula::test {

// The words of a line that calls one of the two, the first of which is its name: without its folder, a
// comment behind #, and the brackets around what may be left out. Empty for any other line.
std::vector<std::string> maculaWords(std::string_view line);

// What may follow these words, by the help of the program that is the first of them.
const std::set<std::string>& verbsBehind(const std::vector<std::string>& verb);

// Why the program would refuse these words, or nothing: a verb or option that it does not have, a choice that
// is not among the option's, a preset, light, clip or quality that is not built in. Words in capitals, files
// and ... stand for what the reader puts there. `isWhole`: the options that the verb requires have to be
// there too.
std::string whyRefused(const std::vector<std::string>& words, bool isWhole);

}  // namespace macula::test
