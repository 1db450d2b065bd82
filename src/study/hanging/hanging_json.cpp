#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>

#include "base/utf8.h"
#include "study/hanging/hanging_protocol.h"

namespace macula::study {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestWords = 200;  // bytes of UTF-8
constexpr int kVersion = 1;

bool isShort(const std::string& text) {
    return text.size() <= kLongestWords && isValidUtf8(text);
}

bool isSound(const ImageSet& set) {
    return set.prior >= 0 && set.prior <= int(kMostPriors) + 1 && isShort(set.modality) &&
           isShort(set.description) && isShort(set.laterality) && isShort(set.view) && set.number < 1000;
}

bool isSound(const HangingProtocol& protocol) {
    return !protocol.name.empty() && protocol.name.size() <= kLongestHangingName &&
           isValidUtf8(protocol.name) && isShort(protocol.modality) && isShort(protocol.bodyPart) &&
           isShort(protocol.description) && protocol.rows >= 1 && protocol.rows <= kMostBoxRows &&
           protocol.columns >= 1 && protocol.columns <= kMostBoxColumns &&
           protocol.boxes.size() <= std::size_t(protocol.rows) * std::size_t(protocol.columns) &&
           std::ranges::all_of(protocol.boxes, [](const ImageSet& set) { return isSound(set); });
}

Error notUsable(Text message) {
    return {ErrorCode::inputNotUsable, std::move(message), {}, Text("Save a hanging protocol again.")};
}

Json toJson(const ImageSet& set) {
    Json json{{"prior", set.prior}, {"number", set.number}};
    const auto add = [&](const char* key, const std::string& text) {
        if (!text.empty()) json[key] = text;
    };
    add("modality", set.modality);
    add("description", set.description);
    add("laterality", set.laterality);
    add("view", set.view);
    return json;
}

// -1, which no value may be, for a number that is none of those up to 1000.
int numberOf(const Json& json, const char* key, int usual) {
    const auto found = json.find(key);
    if (found == json.end()) return usual;
    const bool isNumber = found->is_number_unsigned() && found->get<std::uint64_t>() <= 1000;
    return isNumber ? int(found->get<std::uint64_t>()) : -1;
}

// Throws Json::exception where a text or a switch is of another kind.
ImageSet setFrom(const Json& json) {
    return {.prior = numberOf(json, "prior", 0),
            .modality = json.value("modality", std::string()),
            .description = json.value("description", std::string()),
            .laterality = json.value("laterality", std::string()),
            .view = json.value("view", std::string()),
            .number = std::size_t(numberOf(json, "number", 0))};
}

HangingProtocol protocolFrom(const Json& json) {
    HangingProtocol made{.name = json.at("name").get<std::string>()};
    made.modality = json.value("modality", std::string());
    made.bodyPart = json.value("bodyPart", std::string());
    made.description = json.value("description", std::string());
    made.isOfSlices = json.value("slices", false);
    made.rows = numberOf(json, "rows", 1);
    made.columns = numberOf(json, "columns", 1);
    made.isLinked = json.value("linked", false);
    for (const Json& each : json.at("boxes")) made.boxes.push_back(setFrom(each));
    return made;
}

}  // namespace

std::string toJson(std::span<const HangingProtocol> protocols) {
    Json all = Json::array();
    for (const HangingProtocol& each : protocols) {
        if (!isSound(each) || all.size() == kMostHangingProtocols) continue;
        Json boxes = Json::array();
        for (const ImageSet& set : each.boxes) boxes.push_back(toJson(set));
        all.push_back({{"name", each.name},
                       {"modality", each.modality},
                       {"bodyPart", each.bodyPart},
                       {"description", each.description},
                       {"slices", each.isOfSlices},
                       {"rows", each.rows},
                       {"columns", each.columns},
                       {"linked", each.isLinked},
                       {"boxes", std::move(boxes)}});
    }
    return Json{{"version", kVersion}, {"protocols", std::move(all)}}.dump(2);
}

Result<std::vector<HangingProtocol>> hangingProtocolsFromJson(std::string_view text) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || !json.contains("protocols") || !json["protocols"].is_array())
        return notUsable(Text("These are no hanging protocols."));
    std::vector<HangingProtocol> all;
    for (const Json& each : json["protocols"]) {
        try {
            all.push_back(protocolFrom(each));
        } catch (const Json::exception&) {
            return notUsable(
                Text("Hanging protocol {} lacks a value, or has one of another kind.", all.size() + 1));
        }
        if (!isSound(all.back()) || all.size() > kMostHangingProtocols)
            return notUsable(Text("Hanging protocol {} has a value out of range.", all.size()));
    }
    return all;
}

Result<std::vector<HangingProtocol>> withHangingProtocol(std::vector<HangingProtocol> all,
                                                         HangingProtocol added) {
    const auto fail = [](Text why, Text hint) {
        return Error{ErrorCode::usage, std::move(why), {}, std::move(hint)};
    };
    if (!isSound(added))
        return fail(Text("A hanging protocol has a name of up to {} bytes.", kLongestHangingName),
                    Text("Give it a shorter name."));
    const auto same = std::ranges::find(all, added.name, &HangingProtocol::name);
    if (same != all.end()) {
        *same = std::move(added);
        return all;
    }
    if (all.size() >= kMostHangingProtocols)
        return fail(Text("There are {} hanging protocols already.", kMostHangingProtocols),
                    Text("Remove one first."));
    all.push_back(std::move(added));
    return all;
}

}  // namespace macula::study
