#include "live/store/store_json.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "live/store/time_text.h"

namespace macula::live {

namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<std::string>& text) {
    return text ? Json(*text) : Json();
}

Json toJson(const session::StudyEntry& study) {
    return {{"identity", study.identity},
            {"readable", orNull(study.readable)},
            {"firstOpened", utcTime(study.firstOpenedMs)},
            {"lastOpened", utcTime(study.lastOpenedMs)},
            {"series", study.series},
            {"models", study.models},
            {"modelBytes", study.modelBytes},
            {"documents", study.documents}};
}

Json toJson(const session::SeriesEntry& series) {
    return {{"identity", series.identity},
            {"readable", orNull(series.readable)},
            {"firstOpened", utcTime(series.firstOpenedMs)},
            {"lastOpened", utcTime(series.lastOpenedMs)},
            {"volumes", series.volumes}};
}

Json toJson(const session::ModelInfo& model) {
    Json parts = Json::object();
    for (const session::KeyPart& part : model.key.parts) parts[part.name] = part.digest;
    return {{"volume", model.key.volume},
            {"trainer", model.key.trainer},
            {"parts", std::move(parts)},
            {"bytes", model.bytes},
            {"checksum", model.checksum},
            {"created", utcTime(model.createdMs)},
            {"saved", utcTime(model.savedMs)},
            {"used", utcTime(model.usedMs)},
            {"setAside", model.aside.empty() ? Json() : Json(model.aside)}};
}

Json toJson(const session::DocumentEntry& document) {
    return {{"kind", std::string(session::nameOf(document.id.kind))},
            {"name", document.id.name},
            {"version", document.version},
            {"created", utcTime(document.createdMs)},
            {"changed", utcTime(document.changedMs)}};
}

Json toJson(const session::AuditEntry& entry) {
    return {{"id", entry.id},     {"at", utcTime(entry.atMs)}, {"action", entry.action},
            {"kind", entry.kind}, {"subject", entry.subject},  {"amount", entry.amount}};
}

template <class T>
Json listOf(const std::vector<T>& entries) {
    Json list = Json::array();
    for (const T& entry : entries) list.push_back(toJson(entry));
    return list;
}

Json toJson(const session::SetAside& aside) {
    return {{"folder", aside.folder.string()},
            {"rows", aside.rowsRescued},
            {"models", aside.modelsRescued},
            {"documents", aside.documentsRescued}};
}

}  // namespace

Json toJson(const StoredStudies& stored) {
    return {{"folder", stored.folder.string()},
            {"studies", listOf(stored.studies.entries)},
            {"damagedStudies", stored.studies.damaged},
            {"models", stored.models.models},
            {"modelBytes", stored.models.bytes},
            {"modelsWithoutStudy", stored.withoutStudy.models},
            {"modelBytesWithoutStudy", stored.withoutStudy.bytes},
            {"modelsSetAside", stored.modelsAside}};
}

Json toJson(const StoredStudy& study) {
    Json json = toJson(study.study);
    json["series"] = listOf(study.series.entries);
    json["models"] = listOf(study.models.entries);
    json["documents"] = listOf(study.documents.entries);
    json["damaged"] = study.series.damaged + study.models.damaged + study.documents.damaged;
    return json;
}

Json toJson(const VerifiedStore& verified) {
    const session::VerifyReport& report = verified.report;
    const auto& aside = verified.notes.setAside;
    return {{"sound", verified.isSound()},
            {"databaseSound", report.isDatabaseSound},
            {"rows", report.rows},
            {"models", report.blobs},
            {"damagedRows", report.damagedRows},
            {"damagedModels", report.damagedBlobs},
            {"setAside", report.setAside},
            {"leftOvers", report.orphans},
            {"damagedFolders", report.damagedFolders},
            {"rescued", aside ? toJson(*aside) : Json()},
            {"rescuePending", verified.isRescuePending}};
}

Json toJson(const Tidied& tidied) {
    return {{"evictedModels", tidied.evicted.models},
            {"evictedBytes", tidied.evicted.bytes},
            {"modelBytesLeft", tidied.evicted.bytesLeft},
            {"leftOvers", tidied.leftOvers.blobs},
            {"leftOverBytes", tidied.leftOvers.bytes}};
}

Json toJson(const session::SnapshotReport& copied) {
    return {{"studies", copied.studies},
            {"models", copied.models},
            {"documents", copied.documents},
            {"skipped", copied.skipped},
            {"damaged", copied.damaged}};
}

Json toJson(const PurgePlan& plan) {
    Json identities = Json::array();
    for (const session::StudyEntry& study : plan.studies) identities.push_back(study.identity);
    return {{"dryRun", true},
            {"studies", std::move(identities)},
            {"models", plan.models.models},
            {"modelBytes", plan.models.bytes},
            {"documents", plan.documents},
            {"clock", nameOf(plan.clock)}};
}

Json toJson(const session::PurgeReport& purged) {
    return {{"studies", purged.studies},         {"volumes", purged.volumes},
            {"models", purged.models},           {"documents", purged.documents},
            {"skippedOpen", purged.skippedOpen}, {"damagedFolders", purged.damagedFolders},
            {"clock", nameOf(purged.clock)}};
}

Json toJson(const session::Listing<session::AuditEntry>& trail) {
    return {{"entries", listOf(trail.entries)}, {"damaged", trail.damaged}};
}

}  // namespace macula::live
