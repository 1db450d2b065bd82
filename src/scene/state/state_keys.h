// The keys of the text of a StudyState.
#pragma once

#include <string>
#include <vector>

namespace macula::scene {

// The outermost keys that toJson(StudyState) writes where there is something to write. A store that updates
// an older text removes those of them that the new text lacks: they are no longer set.
std::vector<std::string> stateKeys();

}  // namespace macula::scene
