// What somebody may have meant by a name that does not exist.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace macula::app {

// The name that takes the fewest changes to get to; empty when all take more than a third of what was typed.
std::string nearestName(std::string_view typed, const std::vector<std::string>& names);

// "Did you mean ct-bone? There are: ct-aaa, ct-bone."
std::string choiceAmong(std::string_view typed, const std::vector<std::string>& names);

// usage. `sentence` says that there is no such thing; the hint is choiceAmong, then `orElse`, what else may
// be given: a sentence, or nothing.
Error noSuchName(std::string_view sentence, const std::string& typed, const std::vector<std::string>& names,
                 std::string_view orElse = {});

}  // namespace macula::app
