// The documents of a store. Private to src/session.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "session/store.h"
#include "session/store_state.h"

namespace macula::session {

// The contracts are those of Store. Uses the connection of the state.
class StoreDocuments {
  public:
    explicit StoreDocuments(StoreState& state) : state_(state) {}

    Result<void> change(const DocumentId& id, std::int64_t version, const Store::DocumentEdit& edit,
                        std::span<const std::string_view> known);
    Result<std::optional<Document>> get(const DocumentId& id);
    Result<Listing<DocumentEntry>> list(DocumentKind kind, const std::string& study);
    Result<bool> remove(const DocumentId& id);

  private:
    StoreState& state_;
};

}  // namespace macula::session
