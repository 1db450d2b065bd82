#include "scene/transfer/own_copy.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "presets/preset_name.h"

namespace macula::scene {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDerivedFrom = "derivedFrom";
constexpr std::size_t kLongestStem = 48;  // bytes; a name has at most 64

Json documentOf(const TransferFunction& function) {
    Json document = Json::parse(function.document, nullptr, false);
    if (!document.is_object()) document = Json::object();
    return document;
}

// Returns "CT-Bone" for "CT-Bone (edited 2)".
std::string_view withoutEdited(std::string_view title) {
    constexpr std::string_view kMark = " (edited";
    const std::size_t at = title.rfind(kMark);
    if (at == std::string_view::npos || at == 0 || !title.ends_with(')')) return title;
    std::string_view number = title.substr(at + kMark.size());
    number.remove_suffix(1);
    const bool isOurs =
        number.empty() || (number.size() > 1 && number.front() == ' ' &&
                           number.find_first_not_of("0123456789", 1) == std::string_view::npos);
    return isOurs ? title.substr(0, at) : title;
}

std::string text(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string documentOfCopy(const TransferFunction& original) {
    Json document = documentOf(original);
    Json& macula = document["macula"];
    if (!macula.is_object()) macula = Json::object();
    macula.erase("id");
    macula.erase("sha256");
    const std::string found = text(macula, "provenance");
    macula["provenance"] =
        fmt::format("Edited copy of {}{}{}", original.title, found.empty() ? "" : ", which is: ", found);
    macula[kDerivedFrom] = original.name;
    return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

TransferFunction ownCopy(const TransferFunction& function, const std::set<std::string>& taken) {
    const std::string title(withoutEdited(function.title.empty() ? function.name : function.title));
    std::string stem = presets::keyFrom(title).substr(0, kLongestStem);
    while (stem.ends_with('-')) stem.pop_back();

    TransferFunction copy = function;
    copy.title = title + " (edited)";
    copy.name = stem + "-edited";
    for (int number = 2; taken.contains(copy.name) || copy.name == function.name; ++number) {
        copy.title = fmt::format("{} (edited {})", title, number);
        copy.name = fmt::format("{}-edited-{}", stem, number);
    }
    copy.number.reset();
    copy.document = documentOfCopy(function);
    return copy;
}

std::string copiedFrom(const TransferFunction& function) {
    if (function.document.find(kDerivedFrom) == std::string::npos) return {};
    const Json document = documentOf(function);
    const auto macula = document.find("macula");
    return macula != document.end() && macula->is_object() ? text(*macula, kDerivedFrom) : std::string();
}

}  // namespace macula::scene
