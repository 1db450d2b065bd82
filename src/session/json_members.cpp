#include "session/json_members.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace macula::session {

namespace {

using nlohmann::json;

json parsed(std::string_view text) {
    bool isDeep = false;
    json value = json::parse(
        text,
        [&](int depth, json::parse_event_t, json&) {
            isDeep = isDeep || depth > kMostJsonDepth;
            return !isDeep;
        },
        false);
    return isDeep ? json(json::value_t::discarded) : value;
}

// Returns true if it added something.
bool addUnknown(json& written, const json& before, const std::string& path,
                std::span<const std::string_view> known) {
    bool isChanged = false;
    for (const auto& [name, value] : before.items()) {
        std::string here = path;
        if (!here.empty()) here += ".";
        here += name;
        const bool isKnown = std::ranges::find(known, here) != known.end();
        const bool isLookedInto = std::ranges::any_of(known, [&](std::string_view other) {
            return other.size() > here.size() && other.starts_with(here) && other[here.size()] == '.';
        });
        const auto present = written.find(name);
        if (present == written.end()) {
            if (isKnown) continue;
            written[name] = value;
            isChanged = true;
        } else if (isLookedInto && present->is_object() && value.is_object()) {
            isChanged = addUnknown(*present, value, here, known) || isChanged;
        }
    }
    return isChanged;
}

}  // namespace

bool isDocument(std::string_view text) {
    return text.size() <= kMostJsonBytes && parsed(text).is_object();
}

std::string withUnknownMembers(std::string_view written, std::string_view before,
                               std::span<const std::string_view> known) {
    json value = parsed(written);
    const json old = parsed(before);
    if (!value.is_object() || !old.is_object() || !addUnknown(value, old, {}, known))
        return std::string(written);
    return value.dump();
}

}  // namespace macula::session
