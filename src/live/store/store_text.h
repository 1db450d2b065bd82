// Reports on stored sessions for people: whole lines, sizes in MB and GB, local times. They contain readable
// texts of a study, if the store keeps those.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/text.h"
#include "live/store/purge_plan.h"
#include "live/store/store_maintenance.h"
#include "live/store/stored_studies.h"
#include "session/store.h"

namespace macula::live {

std::string textOf(const StoredStudies& stored);
std::string textOf(const StoredStudy& study);
std::string textOf(const VerifiedStore& verified);
std::string textOf(const Tidied& tidied);
std::string textOf(const session::SnapshotReport& copied);
std::string textOf(const PurgePlan& plan);
std::string textOf(const session::PurgeReport& purged);
std::string textOf(const session::Listing<session::AuditEntry>& trail);

std::string nothingStoredText(const std::filesystem::path& folder);

// Sentences, without an end of line.
std::string questionOf(const PurgePlan& plan);
std::vector<Text> warningsOf(const session::OpeningNotes& notes);
// What a purge should have deleted, but left.
std::vector<Text> warningsOf(const session::PurgeReport& purged);
// What to do if not everything is sound; one sentence or more.
std::string whatToDo(const VerifiedStore& verified);

}  // namespace macula::live
