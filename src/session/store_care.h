// Verification and garbage collection of a store. Private to src/session.
#pragma once

#include "base/progress.h"
#include "session/store.h"
#include "session/store_state.h"

namespace macula::session {

// The contracts are those of Store. Uses connection, locks and blobs of the state.
class StoreCare {
  public:
    explicit StoreCare(StoreState& state) : state_(state) {}

    Result<VerifyReport> verify(Progress& progress);
    Result<GcReport> collectGarbage();

  private:
    StoreState& state_;
};

}  // namespace macula::session
