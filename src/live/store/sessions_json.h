// Reports on stored sessions as JSON: sizes in bytes, times in UTC.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "live/store/purge_plan.h"
#include "live/store/stored_sessions.h"
#include "live/store/tidied_sessions.h"
#include "live/store/verified_sessions.h"
#include "session/store.h"

namespace macula::app {

nlohmann::ordered_json toJson(const StoredSessions& stored);
nlohmann::ordered_json toJson(const StoredStudy& study);
nlohmann::ordered_json toJson(const VerifiedSessions& verified);
nlohmann::ordered_json toJson(const Tidied& tidied);
nlohmann::ordered_json toJson(const session::SnapshotReport& copied);
nlohmann::ordered_json toJson(const PurgePlan& plan);
nlohmann::ordered_json toJson(const session::PurgeReport& purged);
nlohmann::ordered_json toJson(const session::Listing<session::AuditEntry>& trail);

}  // namespace macula::app
