// Export and import of a store. Private to src/session.
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "session/store.h"
#include "session/store_state.h"

namespace macula::session {

// The contracts are those of Store. Uses connection, locks and blobs of the state.
class StoreSnapshots {
  public:
    explicit StoreSnapshots(StoreState& state) : state_(state) {}

    Result<SnapshotReport> exportTo(const std::filesystem::path& newFolder, Progress& progress);
    Result<SnapshotReport> importFrom(const std::filesystem::path& folder, Progress& progress);

  private:
    StoreState& state_;
};

}  // namespace macula::session
