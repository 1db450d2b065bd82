#include "cli/shared/name_option.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/text.h"
#include "pipeline/trace/settings.h"
#include "scene/camera/view_directions.h"
#include "scene/choice/nearest_name.h"

namespace macula::cli {

CLI::Validator oneOf(std::map<std::string, int> numbersByName) {
    std::vector<std::string> names;
    for (const auto& [name, number] : numbersByName) names.push_back(name);
    const std::string all = fmt::format("{}", fmt::join(names, "|"));
    const auto toNumber = [numbers = std::move(numbersByName), names](std::string& text) -> std::string {
        const auto found = numbers.find(text);
        if (found == numbers.end())
            return Text("there is no {}. {}", text, scene::choiceAmong(text, names)).english();
        text = std::to_string(found->second);
        return {};
    };
    return {toNumber, all, "name"};
}

CLI::Validator asViewDirection() {
    const auto toNumber = [](std::string& text) -> std::string {
        const auto direction = scene::viewDirectionOf(text);
        if (!direction)
            return text +
                   " is no direction: choose anterior (the front), posterior, left, right, superior, "
                   "inferior, oblique, three-quarter or turned";
        text = std::to_string(static_cast<int>(*direction));
        return {};
    };
    return {toNumber, kViewDirectionNames, "direction"};
}

CLI::Validator asFilter() {
    std::map<std::string, int> filters;
    for (const trace::Filter filter : trace::kFilters)
        filters.emplace(trace::nameOf(filter), static_cast<int>(filter));
    return oneOf(std::move(filters));
}

CLI::Validator asToneMap() {
    std::map<std::string, int> maps;
    for (const trace::ToneMap map : trace::kToneMaps) maps.emplace(trace::nameOf(map), static_cast<int>(map));
    return oneOf(std::move(maps));
}

}  // namespace macula::cli
