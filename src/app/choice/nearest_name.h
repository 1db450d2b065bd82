// What somebody may have meant by a name that does not exist.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace macula::app {

// The name that takes the fewest changes to get to; empty when all take more than a third of what was typed.
std::string nearestName(std::string_view typed, const std::vector<std::string>& names);

// "Did you mean ct-bone? There are: ct-aaa, ct-bone."
std::string choiceAmong(std::string_view typed, const std::vector<std::string>& names);

}  // namespace macula::app
