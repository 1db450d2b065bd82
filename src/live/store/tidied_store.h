// Makes room in the study store.
#pragma once

#include <cstdint>

#include "base/result.h"
#include "session/store.h"

namespace macula::live {

struct Tidied {
    session::EvictionReport evicted;
    session::GcReport leftOvers;
};

// Removes models, the least recently used first, until the others take at most `capBytes`, then what killed
// programs left behind. Open models stay. The audit trail gets the number removed. Fails as
// Store::evictModels.
Result<Tidied> tidyStore(session::Store& store, std::uint64_t capBytes);

}  // namespace macula::live
