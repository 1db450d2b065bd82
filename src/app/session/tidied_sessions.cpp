#include "app/session/tidied_sessions.h"

namespace macula::app {

Result<Tidied> tidySessions(session::Store& store, std::uint64_t capBytes) {
    Tidied tidied;
    MACULA_TRY(tidied.evicted, store.evictModels(capBytes));
    MACULA_TRY(tidied.leftOvers, store.collectGarbage());
    return tidied;
}

}  // namespace macula::app
