#include "live/store/machine_documents.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "base/check.h"

namespace macula::live {

namespace {

Result<session::Store> storeIn(const std::filesystem::path& folder) {
    session::StoreOptions options;
    options.folder = folder;
    return session::Store::open(options);
}

}  // namespace

Result<std::optional<std::string>> machineDocument(const std::filesystem::path& folder,
                                                   const session::DocumentId& id) {
    MACULA_CHECK(id.study.empty());
    MACULA_TRY(session::Store store, storeIn(folder));
    MACULA_TRY(const std::optional<session::Document> found, store.getDocument(id));
    return found ? std::optional(found->json) : std::nullopt;
}

Result<void> keepMachineDocument(const std::filesystem::path& folder, const session::DocumentId& id,
                                 std::int64_t version, std::string_view json) {
    MACULA_CHECK(id.study.empty());
    MACULA_TRY(session::Store store, storeIn(folder));
    const auto object = nlohmann::json::parse(json, nullptr, false);
    std::vector<std::string> keys;
    if (object.is_object()) {
        for (const auto& item : object.items()) keys.push_back(item.key());
    }
    const std::vector<std::string_view> known(keys.begin(), keys.end());
    return store.putDocument(id, version, json, known);
}

}  // namespace macula::live
