// Suggestions for a name that does not exist.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace macula::scene {

// The name at the smallest edit distance; empty if that is above a third of the typed length, rounded up.
std::string nearestName(std::string_view typed, const std::vector<std::string>& names);

// "Did you mean ct-bone? There are: ct-aaa, ct-bone."
Text choiceAmong(std::string_view typed, const std::vector<std::string>& names);

// A usage error. `sentence` says that there is no such thing; the hint is choiceAmong, then `orElse`, a
// sentence on what else is accepted, which may be empty.
Error noSuchName(Text sentence, const std::string& typed, const std::vector<std::string>& names,
                 const Text& orElse = {});

}  // namespace macula::scene
