// Reports on stored sessions as JSON: sizes in bytes, times in UTC.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "live/store/purge_plan.h"
#include "live/store/store_maintenance.h"
#include "live/store/stored_studies.h"
#include "session/store.h"

namespace macula::live {

nlohmann::ordered_json toJson(const StoredStudies& stored);
nlohmann::ordered_json toJson(const StoredStudy& study);
nlohmann::ordered_json toJson(const VerifiedStore& verified);
nlohmann::ordered_json toJson(const Tidied& tidied);
nlohmann::ordered_json toJson(const session::SnapshotReport& copied);
nlohmann::ordered_json toJson(const PurgePlan& plan);
nlohmann::ordered_json toJson(const session::PurgeReport& purged);
nlohmann::ordered_json toJson(const session::Listing<session::AuditEntry>& trail);

}  // namespace macula::live
