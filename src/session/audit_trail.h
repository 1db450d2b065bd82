// The audit trail of a store. Private to src/session.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "session/store.h"
#include "session/store_state.h"

namespace macula::session {

// The contracts are those of Store. Within a transaction, call addAuditRow instead.
class AuditTrail {
  public:
    explicit AuditTrail(StoreState& state) : state_(state) {}

    Result<void> add(AuditAction action, AuditKind kind, const std::string& subject, std::int64_t amount);
    Result<Listing<AuditEntry>> list(std::size_t most);

  private:
    StoreState& state_;
};

}  // namespace macula::session
