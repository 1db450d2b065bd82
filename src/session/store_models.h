// The models of a store. Private to src/session.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "session/store.h"
#include "session/store_state.h"

namespace macula::session {

// The contracts are those of Store. Uses connection, locks and blobs of the state.
class StoreModels {
  public:
    explicit StoreModels(StoreState& state) : state_(state) {}

    Result<SaveReport> save(const ModelKey& key, std::span<const std::byte> blob);
    Result<std::optional<ModelInfo>> find(const ModelKey& key);
    Result<std::vector<ModelCandidate>> nearest(const ModelKey& key, std::size_t most);
    Result<LoadedModel> read(const ModelInfo& info);
    Result<std::filesystem::path> fileOf(const ModelInfo& info) const;
    Result<void> setAside(const ModelInfo& info, std::string_view why);
    Result<Listing<ModelInfo>> list(const std::string& volume);
    Result<void> touch(const ModelKey& key);
    Result<OpenMark> markOpen(const ModelKey& key);
    Result<EvictionReport> evict(std::uint64_t capBytes);

  private:
    StoreState& state_;
};

}  // namespace macula::session
