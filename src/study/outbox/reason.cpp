#include "study/outbox/reason.h"

#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>
#include <vector>

namespace macula::study {

namespace {

using Json = nlohmann::json;

constexpr int kDeepestText = 8;  // arguments of arguments; Macula's own have one or two

Json jsonOf(const Text& text) {
    Json arguments = Json::array();
    for (const TextArgument& argument : text.arguments()) {
        Json value = std::visit(
            [](const auto& each) {
                if constexpr (std::is_same_v<std::decay_t<decltype(each)>, Text>)
                    return jsonOf(each);
                else
                    return Json(each);
            },
            argument.value);
        arguments.push_back({{"name", argument.name}, {"value", std::move(value)}});
    }
    return {{"format", text.format()}, {"arguments", std::move(arguments)}};
}

std::optional<Text> textIn(const Json& json, int deepest = kDeepestText);

std::optional<TextArgument> argumentIn(const Json& json, int deepest) {
    if (!json.is_object() || !json.contains("name") || !json["name"].is_string() || !json.contains("value"))
        return std::nullopt;
    const Json& value = json["value"];
    TextArgument argument{.name = json["name"], .value = {}};
    if (value.is_number_integer()) {
        argument.value = value.get<std::int64_t>();
    } else if (value.is_number_float()) {
        argument.value = value.get<double>();
    } else if (value.is_string()) {
        argument.value = value.get<std::string>();
    } else if (auto text = textIn(value, deepest - 1); text) {
        argument.value = *std::move(text);
    } else {
        return std::nullopt;
    }
    return argument;
}

std::optional<Text> textIn(const Json& json, int deepest) {
    if (deepest == 0 || !json.is_object() || !json.contains("format") || !json["format"].is_string() ||
        !json.contains("arguments") || !json["arguments"].is_array())
        return std::nullopt;
    std::vector<TextArgument> arguments;
    for (const Json& each : json["arguments"]) {
        auto argument = argumentIn(each, deepest);
        if (!argument) return std::nullopt;
        arguments.push_back(*std::move(argument));
    }
    return Text::of(json["format"].get<std::string>(), std::move(arguments));
}

}  // namespace

nlohmann::json toJson(const Reason& reason) {
    return {{"why", jsonOf(reason.why)}, {"advice", jsonOf(reason.advice)}};
}

std::optional<Reason> reasonFromJson(const nlohmann::json& json) {
    if (!json.is_object() || !json.contains("why") || !json.contains("advice")) return std::nullopt;
    auto why = textIn(json["why"]);
    auto advice = textIn(json["advice"]);
    if (!why || !advice) return std::nullopt;
    return Reason{*std::move(why), *std::move(advice)};
}

}  // namespace macula::study
