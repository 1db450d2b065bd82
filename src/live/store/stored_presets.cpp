#include "live/store/stored_presets.h"

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "pipeline/volume/json_reader.h"
#include "session/trouble.h"

namespace macula::live {

namespace {

using Json = nlohmann::ordered_json;
using session::DocumentKind;

constexpr std::int64_t kVersion = 1;
constexpr std::string_view kOwnPrefix = "own-";  // prefix of OwnPreset::id
constexpr std::string_view kFavouritePrefix = "preset ";

// All keys that this version writes: any that a new document lacks are removed from the stored one.
constexpr std::array<std::string_view, 4> kPresetKeys{"title", "preset", "seen", "camera"};
constexpr std::array<std::string_view, 1> kFavouriteKeys{"preset"};
constexpr std::array<std::string_view, 1> kLastUsedKeys{"lastUsed"};

std::span<const std::string_view> keysOf(const PresetDocument& document) {
    if (document.kind == DocumentKind::preset) return kPresetKeys;
    if (document.name == kLastUsedDocument) return kLastUsedKeys;
    return kFavouriteKeys;
}

void checkVersion(const JsonNode& root) {
    if (root["version"].number() != double(kVersion))
        root["version"].fail(Text("version 1; newer ones need a newer Macula"));
}

Result<PresetRef> favouriteFrom(std::string_view text) {
    const JsonDocument document(text, {});
    MACULA_TRY_VOID(document.status());
    checkVersion(document.root());
    std::string ref = document.root()["preset"].text();
    MACULA_TRY_VOID(document.status());
    return ref;
}

Result<std::vector<UsedPreset>> lastUsedFrom(std::string_view text) {
    const JsonDocument document(text, {});
    MACULA_TRY_VOID(document.status());
    checkVersion(document.root());
    std::vector<UsedPreset> used;
    for (const JsonNode& node : document.root()["lastUsed"].items(0, 1000))
        used.push_back({node["preset"].text(), node["modality"].text()});
    MACULA_TRY_VOID(document.status());
    return used;
}

// The JSON of a document; nothing if it is damaged, and the store has set it aside, or if another program has
// removed it.
Result<std::optional<std::string>> textOf(session::Store& store, const session::DocumentId& id,
                                          std::size_t& damaged) {
    auto document = store.getDocument(id);
    if (document) return *document ? std::optional((*document)->json) : std::nullopt;
    if (session::troubleOf(document.error()) != session::Trouble::documentDamaged) return document.error();
    ++damaged;
    return std::optional<std::string>();
}

}  // namespace

std::string favouriteDocumentName(const PresetRef& ref) {
    return std::string(kFavouritePrefix) + ref;
}

std::string favouriteJson(const PresetRef& ref) {
    return Json{{"version", kVersion}, {"preset", ref}}.dump();
}

std::string lastUsedJson(std::span<const UsedPreset> used) {
    Json list = Json::array();
    for (const UsedPreset& each : used)
        list.push_back({{"preset", each.preset}, {"modality", each.modality}});
    const Json json{{"version", kVersion}, {"lastUsed", std::move(list)}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<StoredPresets> readStoredPresets(session::Store& store) {
    StoredPresets stored;
    MACULA_TRY(const auto own, store.listDocuments(DocumentKind::preset, {}));
    MACULA_TRY(const auto favourites, store.listDocuments(DocumentKind::favourite, {}));
    stored.damaged = own.damaged + favourites.damaged;
    for (const session::DocumentEntry& entry : own.entries) {
        if (!entry.id.name.starts_with(kOwnPrefix)) continue;  // such as windows of slices
        MACULA_TRY(const auto text, textOf(store, entry.id, stored.damaged));
        if (!text) continue;
        auto preset = ownPresetFromJson(entry.id.name, *text);
        if (preset) {
            stored.own.push_back(*std::move(preset));
        } else {
            ++stored.unreadable;
        }
    }
    for (const session::DocumentEntry& entry : favourites.entries) {
        const bool isLastUsed = entry.id.name == kLastUsedDocument;
        if (!isLastUsed && !entry.id.name.starts_with(kFavouritePrefix)) continue;  // another kind
        MACULA_TRY(const auto text, textOf(store, entry.id, stored.damaged));
        if (!text) continue;
        if (isLastUsed) {
            if (auto used = lastUsedFrom(*text)) {
                stored.lastUsed = *std::move(used);
            } else {
                ++stored.unreadable;
            }
        } else if (auto ref = favouriteFrom(*text)) {
            stored.favourites.push_back(*std::move(ref));
        } else {
            ++stored.unreadable;
        }
    }
    return stored;
}

Result<void> writePresetDocument(session::Store& store, const PresetDocument& document) {
    const session::DocumentId id{document.kind, {}, document.name};
    if (document.json) return store.putDocument(id, kVersion, *document.json, keysOf(document));
    const auto removed = store.removeDocument(id);
    return removed ? Result<void>() : Result<void>(removed.error());
}

}  // namespace macula::live
