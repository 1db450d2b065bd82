// One study, changed in two windows: what is kept of both.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace macula::app {

struct MergedState {
    std::string json;  // as toJson(StudyState)
    // Whether it has measurements or clips with a name that `mine` has not.
    bool holdsMore = false;
};

// Texts of toJson(StudyState): `mine` was made of `base`, and `theirs` is what is kept now. What only one of
// them has changed is as they have it; what both have changed is as in `mine`, but for measurements and clips
// with a name, of which those are in it that either has added or changed. One that either has removed, and
// the other has left as it was, is gone. `mine` itself where nobody else has changed anything, or `theirs` is
// no state. Nothing: together they are more than a state may hold.
std::optional<MergedState> mergedState(std::string_view base, std::string_view mine, std::string_view theirs);

}  // namespace macula::app
