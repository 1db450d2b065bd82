#include "cli/view_directions.h"

#include <algorithm>
#include <map>

#include "base/check.h"

namespace macula::cli {

namespace {

const std::map<std::string, ViewDirection>& viewDirections() {
    static const std::map<std::string, ViewDirection> directions{
        {"anterior", ViewDirection::anterior}, {"posterior", ViewDirection::posterior},
        {"left", ViewDirection::left},         {"right", ViewDirection::right},
        {"superior", ViewDirection::superior}, {"inferior", ViewDirection::inferior}};
    return directions;
}

}  // namespace

CLI::Validator asViewDirection() {
    const auto toNumber = [](std::string& text) -> std::string {
        const auto found = viewDirections().find(text);
        if (found == viewDirections().end())
            return text +
                   " is no direction: choose anterior (the front), posterior, left, right, superior or "
                   "inferior";
        text = std::to_string(static_cast<int>(found->second));
        return {};
    };
    return {toNumber, kViewDirectionNames, "direction"};
}

std::string nameOf(ViewDirection direction) {
    const auto& all = viewDirections();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.second == direction; });
    MACULA_CHECK(found != all.end());
    return found->first;
}

}  // namespace macula::cli
