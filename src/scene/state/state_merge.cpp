#include "scene/state/state_merge.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "scene/state/study_state.h"

namespace macula::scene {

namespace {

using Json = nlohmann::json;

// Lists that are merged item by item.
constexpr std::array<std::string_view, 3> kLists{"measurements", "furtherMeasurements", "namedClips"};

Json objectOf(std::string_view text) {
    Json json = Json::parse(text, nullptr, false);
    return json.is_object() ? json : Json::object();
}

// Null if the key is missing.
Json valueOf(const Json& object, const std::string& key) {
    const auto found = object.find(key);
    return found == object.end() ? Json() : *found;
}

bool holds(const Json& list, const Json& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

// Removes one equal item; returns false if there is none.
bool takeOne(Json& list, const Json& value) {
    const auto found = std::find(list.begin(), list.end(), value);
    if (found == list.end()) return false;
    list.erase(found);
    return true;
}

Json mergedList(const Json& base, const Json& mine, const Json& theirs) {
    Json removed = base.is_array() ? base : Json::array();  // removed by `mine`
    Json added = Json::array();                             // added by `mine`
    for (const Json& item : mine) {
        if (!takeOne(removed, item)) added.push_back(item);
    }
    Json merged = Json::array();
    for (const Json& item : theirs) {
        if (!takeOne(removed, item)) merged.push_back(item);
    }
    for (const Json& item : added) {
        if (!holds(merged, item)) merged.push_back(item);
    }
    return merged;
}

}  // namespace

std::optional<MergedState> mergedState(std::string_view base, std::string_view mine,
                                       std::string_view theirs) {
    const Json before = objectOf(base);
    const Json now = objectOf(mine);
    const Json kept = objectOf(theirs);
    Json merged = now;
    MergedState result{.json = std::string(mine)};
    if (kept.empty()) return result;
    for (const std::string& key : stateKeys()) {
        const Json was = valueOf(before, key);
        const Json own = valueOf(now, key);
        const Json other = valueOf(kept, key);
        if (other == was || other == own) continue;
        const bool isList = std::ranges::find(kLists, key) != kLists.end();
        if (isList) {
            const Json both = mergedList(was, own.is_array() ? own : Json::array(),
                                         other.is_array() ? other : Json::array());
            result.holdsMore =
                result.holdsMore ||
                std::any_of(both.begin(), both.end(), [&](const Json& item) { return !holds(own, item); });
            merged[key] = both;
        } else if (own == was) {
            merged[key] = other;
        }
        if (merged.contains(key) && (merged[key].is_null() || (isList && merged[key].empty())))
            merged.erase(key);
    }
    if (merged == now) return result;
    result.json = merged.dump(2);
    if (!studyStateFromJson(result.json, {})) return std::nullopt;
    return result;
}

}  // namespace macula::scene
