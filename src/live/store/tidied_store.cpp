#include "live/store/tidied_store.h"

namespace macula::live {

Result<Tidied> tidyStore(session::Store& store, std::uint64_t capBytes) {
    Tidied tidied;
    MACULA_TRY(tidied.evicted, store.evictModels(capBytes));
    MACULA_TRY(tidied.leftOvers, store.collectGarbage());
    // Last: on a full disk there is room for it now.
    if (tidied.evicted.models > 0)
        MACULA_TRY_VOID(store.addAudit(session::AuditAction::deleted, session::AuditKind::model, {},
                                       std::int64_t(tidied.evicted.models)));
    return tidied;
}

}  // namespace macula::live
