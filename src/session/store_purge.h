// Deletes data of a store for good. Private to src/session.
#pragma once

#include <chrono>
#include <string>

#include "session/store.h"
#include "session/store_state.h"

namespace macula::session {

// The contracts are those of Store. Uses connection, locks and blobs of the state.
class StorePurge {
  public:
    explicit StorePurge(StoreState& state) : state_(state) {}

    Result<PurgeReport> study(const std::string& study, DamagedFiles damaged);
    Result<PurgeReport> volume(const std::string& volume, DamagedFiles damaged);
    Result<PurgeReport> unused(std::chrono::days retention, DamagedFiles damaged, Store::Clock clock);
    Result<PurgeReport> all(DamagedFiles damaged);
    Result<ClockDoubt> clockDoubt(std::chrono::days retention);

  private:
    StoreState& state_;
};

}  // namespace macula::session
