#include "scene/camera/view_directions.h"

#include <algorithm>
#include <map>

#include "base/check.h"

namespace macula::scene {

namespace {

const std::map<std::string, ViewDirection>& viewDirections() {
    static const std::map<std::string, ViewDirection> directions{
        {"anterior", ViewDirection::anterior}, {"posterior", ViewDirection::posterior},
        {"left", ViewDirection::left},         {"right", ViewDirection::right},
        {"superior", ViewDirection::superior}, {"inferior", ViewDirection::inferior},
        {"oblique", ViewDirection::oblique},   {"three-quarter", ViewDirection::threeQuarter},
        {"turned", ViewDirection::turned}};
    return directions;
}

}  // namespace

std::optional<ViewDirection> viewDirectionOf(std::string_view name) {
    const auto found = viewDirections().find(std::string(name));
    return found == viewDirections().end() ? std::nullopt : std::optional(found->second);
}

std::string nameOf(ViewDirection direction) {
    const auto& all = viewDirections();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.second == direction; });
    MACULA_CHECK(found != all.end());
    return found->first;
}

}  // namespace macula::scene
