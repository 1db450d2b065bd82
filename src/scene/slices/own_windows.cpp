#include "scene/slices/own_windows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/utf8.h"
#include "pipeline/volume/json_reader.h"
#include "pipeline/volume/json_writer.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr JsonRange kCenter{-1e9, 1e9};
constexpr JsonRange kWidth{1e-9, 1e9};
constexpr std::size_t kLongestUnit = 100;
// Names of the unit SUV in windows that older versions stored.
constexpr std::array<std::string_view, 2> kUnitsOfSuvBefore{"g/mL", "SUV"};
constexpr std::array<std::string_view, 3> kFunctions{"LINEAR", "LINEAR_EXACT", "SIGMOID"};

bool isFunction(std::string_view name) {
    return std::ranges::find(kFunctions, name) != kFunctions.end();
}

bool isIn(double value, const JsonRange& range) {
    return value >= range.low && value <= range.high;  // not NaN
}

std::string trimmed(std::string_view text) {
    const auto isBlank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return std::string(text);
}

std::string shortText(const JsonNode& node, std::size_t most) {
    std::string text = node.text();
    if (text.size() > most) node.fail(Text("at most {} bytes", most));
    return text;
}

OwnWindow windowFrom(const JsonNode& node) {
    node.allowOnly({"name", "center", "width", "function", "unit"});
    OwnWindow own{.name = shortText(node["name"], kLongestWindowName),
                  .window = {.center = node["center"].number(kCenter),
                             .width = node["width"].number(kWidth),
                             .explanation = {},
                             .function = {}},
                  .unit = shortText(node["unit"], kLongestUnit)};
    if (own.name.empty()) node["name"].fail(Text("a name"));
    if (const auto function = node.find("function")) {
        own.window.function = function->text();
        if (!isFunction(own.window.function))
            function->fail(Text("\"LINEAR\", \"LINEAR_EXACT\" or \"SIGMOID\""));
    }
    return own;
}

bool isSound(const OwnWindow& own) {
    return !own.name.empty() && own.name.size() <= kLongestWindowName && own.unit.size() <= kLongestUnit &&
           isIn(own.window.center, kCenter) && isIn(own.window.width, kWidth);
}

}  // namespace

std::string toJson(const std::vector<OwnWindow>& windows) {
    Json all = Json::array();
    for (const OwnWindow& own : windows) {
        if (!isSound(own) || all.size() == kMostOwnWindows) continue;
        Json json{{"name", own.name}, {"center", own.window.center}, {"width", own.window.width}};
        if (isFunction(own.window.function)) json["function"] = own.window.function;
        json["unit"] = own.unit;
        all.push_back(std::move(json));
    }
    return prettyJson({{"windows", std::move(all)}});
}

Result<std::vector<OwnWindow>> ownWindowsFromJson(std::string_view text) {
    const JsonDocument document(text, {});
    MACULA_TRY_VOID(document.status());
    std::vector<OwnWindow> windows;
    for (const JsonNode& node : document.root()["windows"].items(0, kMostOwnWindows))
        windows.push_back(windowFrom(node));
    MACULA_TRY_VOID(document.status());
    return windows;
}

std::vector<OwnWindow> ownWindowsFor(const std::vector<OwnWindow>& all, const Volume& volume) {
    std::vector<OwnWindow> fitting;
    const bool isSuv = volume.unit() == Unit::suvBodyWeight;
    std::ranges::copy_if(all, std::back_inserter(fitting), [&](const OwnWindow& own) {
        return own.unit == volume.unitName() ||
               (isSuv && std::ranges::find(kUnitsOfSuvBefore, own.unit) != kUnitsOfSuvBefore.end());
    });
    return fitting;
}

Result<std::vector<OwnWindow>> withOwnWindow(std::vector<OwnWindow> all, OwnWindow added) {
    added.name = trimmed(startOf(trimmed(added.name), kLongestWindowName));
    added.window.explanation.clear();
    if (!isSound(added))
        return Error{
            ErrorCode::usage, Text("A window is kept under a name."), {}, Text("Type one, such as Kidney.")};
    std::erase_if(all,
                  [&](const OwnWindow& own) { return own.name == added.name && own.unit == added.unit; });
    if (all.size() >= kMostOwnWindows)
        return Error{ErrorCode::usage,
                     Text("There are {} windows of your own already.", all.size()),
                     {},
                     Text("Remove one first.")};
    all.push_back(std::move(added));
    return all;
}

}  // namespace macula::scene
