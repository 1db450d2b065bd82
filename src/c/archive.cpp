// Archives that are set up, or that a host describes: how they are opened and tested.
#include "c/archive.h"

#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "c/sized.h"
#include "net/archive/file_meta.h"
#include "net/connect.h"
#include "net/sources/source_json.h"
#include "net/sources/source_list.h"
#include "study/archive/archive_json.h"

namespace macula::c {

using Json = nlohmann::ordered_json;

std::string jsonText(const Json& json) {
    return json.dump(4, ' ', false, Json::error_handler_t::replace);
}

namespace {

Result<std::string> listText() {
    MACULA_TRY(const net::SourceList list, net::SourceList::read(net::SourceFiles::ofUser()));
    Json json = Json::array();
    for (const net::Source& source : list.all()) {
        json.push_back(Json(net::toJson(source)));
        json.back()["isManaged"] = source.isManaged;
    }
    return jsonText(json);
}

Result<net::Secrets> secretsOf(const macula_secrets* given) {
    MACULA_TRY(const macula_secrets secrets, taken(given));
    return net::Secrets{.password = textOrEmpty(secrets.password),
                        .token = textOrEmpty(secrets.token),
                        .keyPassphrase = textOrEmpty(secrets.key_passphrase)};
}

Result<net::Source> sourceOf(const char* text) {
    const nlohmann::json one = nlohmann::json::parse(textOrEmpty(text), nullptr, false);
    if (!one.is_object())
        return badArgument(Text("An archive is not described by an object of JSON."),
                           Text("docs/pacs.md shows what \"sources\" holds: give one of them."));
    const nlohmann::json list{{"version", 1}, {"sources", nlohmann::json::array({one})}};
    MACULA_TRY(std::vector<net::Source> sources, net::sourcesFromJson(list.dump()));
    return std::move(sources.front());
}

struct Chosen {
    std::string name;
    std::unique_ptr<net::Archive> archive;
};

// Opens a handle for what `choose()` returns.
template <class Choose>
macula_status openedArchive(macula_archive** archive, const Choose& choose) {
    if (archive != nullptr) *archive = nullptr;
    return guarded([&]() -> Result<void> {
        if (archive == nullptr) return nullHandle();
        MACULA_TRY(Chosen chosen, choose());
        auto made = std::make_unique<macula_archive>();
        made->name = std::move(chosen.name);
        made->archive = std::move(chosen.archive);
        *archive = opened(std::move(made));
        return {};
    });
}

}  // namespace

Result<void> checkUid(const char* uid) {
    if (net::isUid(textOrEmpty(uid))) return {};
    return badArgument(Text("A study or series is named by a UID, and this is none."),
                       Text("Give the UID that a search has found: digits and dots."));
}

extern "C" {

macula_status macula_archives(const char** json) {
    static thread_local std::string listed;
    if (json != nullptr) *json = nullptr;
    return guarded([&]() -> Result<void> {
        if (json == nullptr) return nullHandle();
        MACULA_TRY(listed, listText());
        *json = listed.c_str();
        return {};
    });
}

macula_status macula_archive_open(const char* name, const macula_secrets* secrets, macula_archive** archive) {
    return openedArchive(archive, [&]() -> Result<Chosen> {
        MACULA_TRY(const net::SourceList list, net::SourceList::read(net::SourceFiles::ofUser()));
        MACULA_TRY(const net::Source source, list.find(textOrEmpty(name)));
        MACULA_TRY(const net::Secrets given, secretsOf(secrets));
        MACULA_TRY(auto made,
                   secrets == nullptr ? net::archiveOf(list, source) : net::archiveOf(source, given));
        return Chosen{source.name, std::move(made)};
    });
}

macula_status macula_archive_of_json(const char* json, const macula_secrets* secrets,
                                     macula_archive** archive) {
    return openedArchive(archive, [&]() -> Result<Chosen> {
        MACULA_TRY(const net::Source source, sourceOf(json));
        MACULA_TRY(const net::Secrets given, secretsOf(secrets));
        MACULA_TRY(auto made, net::archiveOf(source, given));
        return Chosen{source.name, std::move(made)};
    });
}

macula_status macula_archive_test(macula_archive* archive, const macula_progress* progress,
                                  const char** json) {
    return answer(archive, progress, json, [](net::Archive& of, Progress& to) -> Result<Json> {
        const std::vector<net::TestStep> steps = of.test(to);
        if (to.cancelled()) return Error{ErrorCode::cancelled, Text("The test was cancelled."), {}, {}};
        return study::toJson(steps);
    });
}

void macula_archive_close(macula_archive* archive) {
    close(archive);
}

}  // extern "C"

}  // namespace macula::c
