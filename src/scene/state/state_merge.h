// Merges the changes that two windows made to one study.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace macula::scene {

struct MergedState {
    std::string json;  // as toJson(StudyState)
    // Whether it has measurements or named clips that `mine` lacks.
    bool holdsMore = false;
};

// Three-way merge of texts of toJson(StudyState): `mine` was made from `base`, `theirs` is stored now. A key
// that one side changed comes from that side; one that both changed comes from `mine`. Measurements and named
// clips are merged one by one: those that either side added or changed are kept, and those that one side
// removed and the other left unchanged are dropped. Returns `mine` itself if nobody else changed anything or
// `theirs` is not a state; nothing if the result is more than a state may hold.
std::optional<MergedState> mergedState(std::string_view base, std::string_view mine, std::string_view theirs);

}  // namespace macula::scene
