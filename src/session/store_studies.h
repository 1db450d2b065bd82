// The studies and series of a store, and when they were opened. Private to src/session.
#pragma once

#include <string>

#include "session/store.h"
#include "session/store_state.h"

namespace macula::session {

// The contracts are those of Store. Uses the connection of the state.
class StoreStudies {
  public:
    explicit StoreStudies(StoreState& state) : state_(state) {}

    Result<void> recordOpened(const OpenedVolume& opened);
    Result<Listing<StudyEntry>> list();
    Result<Listing<SeriesEntry>> listSeries(const std::string& study);

  private:
    StoreState& state_;
};

}  // namespace macula::session
