// What the text of a StudyState may have.
#pragma once

#include <string>
#include <vector>

namespace macula::app {

// The outermost keys that toJson(StudyState) writes where there is something to write. Who stores the text
// over an older one removes those of them that it lacks: what is not in it was not chosen.
std::vector<std::string> stateKeys();

}  // namespace macula::app
