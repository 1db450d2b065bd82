// Small JSON answers that services give: members of one object, and nothing deep.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace macula::net {

// Null where the text is no JSON. What is deeper than answers are is left out, so that no recursion is long.
inline nlohmann::json flatJson(const std::string& text) {
    constexpr int kDepth = 8;
    const auto isFlat = [](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
        return depth < kDepth;
    };
    nlohmann::json json = nlohmann::json::parse(text, isFlat, false);
    return json.is_discarded() ? nlohmann::json() : json;
}

// Empty where there is no such member, or one of another type.
inline std::string textIn(const nlohmann::json& json, const char* name) {
    if (!json.is_object()) return {};
    const auto member = json.find(name);
    return member != json.end() && member->is_string() ? member->get<std::string>() : std::string();
}
inline std::optional<double> numberIn(const nlohmann::json& json, const char* name) {
    if (!json.is_object()) return std::nullopt;
    const auto member = json.find(name);
    return member != json.end() && member->is_number() ? std::optional(member->get<double>()) : std::nullopt;
}

}  // namespace macula::net
