// Room for what is stored next.
#pragma once

#include <cstdint>

#include "base/result.h"
#include "session/store.h"

namespace macula::app {

struct Tidied {
    session::EvictionReport evicted;
    session::GcReport leftOvers;
};

// Removes models, the least recently used first, until they have at most so many bytes, and then what killed
// programs left. Models that are open stay. How many went is on the audit trail. Fails as Store::evictModels
// does.
Result<Tidied> tidySessions(session::Store& store, std::uint64_t capBytes);

}  // namespace macula::app
