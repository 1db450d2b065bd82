#include "study/outbox/outbox_record.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/atomic_file.h"
#include "base/private_file.h"

namespace macula::study {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostBytesOfRecord = 64u << 20;
constexpr int kVersion = 1;

Error damaged(const fs::path& folder) {
    return {ErrorCode::inputNotUsable, Text("The notes on objects that wait for an archive are damaged."),
            folder.string(), Text("The objects lie in this folder. Send them again, then remove the entry.")};
}

std::string textOf(const Json& json, const char* name) {
    const auto member = json.find(name);
    return member != json.end() && member->is_string() ? member->get<std::string>() : std::string();
}

Json jsonOf(const Identity& patient) {
    return {{"patientName", patient.patientName},
            {"patientId", patient.patientId},
            {"birthDate", patient.birthDate},
            {"sex", patient.sex},
            {"studyDate", patient.studyDate},
            {"studyDescription", patient.studyDescription},
            {"studyInstanceUid", patient.studyInstanceUid}};
}

Identity identityIn(const Json& json) {
    return {.patientName = textOf(json, "patientName"),
            .patientId = textOf(json, "patientId"),
            .birthDate = textOf(json, "birthDate"),
            .sex = textOf(json, "sex"),
            .studyDate = textOf(json, "studyDate"),
            .studyDescription = textOf(json, "studyDescription"),
            .series = {},
            .isOfNobody = false,
            .studyInstanceUid = textOf(json, "studyInstanceUid")};
}

// The name is joined to a path, and the file is sent: nothing but a number may stand there.
bool isNameOfFile(const std::string& name) {
    const std::size_t digits = name.find('.');
    return digits != std::string::npos && digits > 0 && name.substr(digits) == ".dcm" &&
           name.find_first_not_of("0123456789") == digits;
}

std::optional<OutboxFile> fileIn(const Json& json) {
    if (!json.is_object()) return std::nullopt;
    OutboxFile file{.name = textOf(json, "name"), .refused = {}};
    if (json.contains("refused")) file.refused = reasonFromJson(json["refused"]);
    const bool isWhole = isNameOfFile(file.name) && json.contains("refused") == file.refused.has_value();
    return isWhole ? std::optional(std::move(file)) : std::nullopt;
}

std::optional<OutboxRecord> recordIn(const Json& json) {
    if (!json.is_object() || json.value("version", Json()) != kVersion) return std::nullopt;
    OutboxRecord record;
    record.archive = textOf(json, "archive");
    record.address = textOf(json, "address");
    record.queuedAt = textOf(json, "queuedAt");
    record.triedAt = textOf(json, "triedAt");
    const Json tries = json.value("tries", Json());
    const Json patients = json.value("patients", Json());
    const Json files = json.value("files", Json());
    if (record.archive.empty() || !tries.is_number_unsigned() || !patients.is_array() || !files.is_array())
        return std::nullopt;
    record.tries = tries;
    for (const Json& each : patients) {
        if (each.is_object()) record.patients.push_back(identityIn(each));
    }
    for (const Json& each : files) {
        auto file = fileIn(each);
        if (!file) return std::nullopt;
        record.files.push_back(*std::move(file));
    }
    if (json.contains("trouble")) record.trouble = reasonFromJson(json["trouble"]);
    return record.files.empty() ? std::nullopt : std::optional(std::move(record));
}

}  // namespace

std::size_t OutboxRecord::refused() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(files, [](const OutboxFile& file) { return file.refused.has_value(); }));
}

fs::path outboxRecordFile(const fs::path& folder) {
    return folder / "entry.json";
}

Result<OutboxRecord> readOutboxRecord(const fs::path& folder) {
    const auto text = readText(outboxRecordFile(folder), kMostBytesOfRecord);
    auto record = text ? recordIn(Json::parse(*text, nullptr, false)) : std::nullopt;
    if (!record) return damaged(folder);
    return *std::move(record);
}

Result<void> writeOutboxRecord(const fs::path& folder, const OutboxRecord& record) {
    Json patients = Json::array();
    for (const Identity& each : record.patients) patients.push_back(jsonOf(each));
    Json files = Json::array();
    for (const OutboxFile& each : record.files) {
        files.push_back({{"name", each.name}});
        if (each.refused) files.back()["refused"] = toJson(*each.refused);
    }
    Json json{{"version", kVersion},
              {"archive", record.archive},
              {"address", record.address},
              {"queuedAt", record.queuedAt},
              {"tries", record.tries},
              {"triedAt", record.triedAt},
              {"patients", std::move(patients)},
              {"files", std::move(files)}};
    if (record.trouble) json["trouble"] = toJson(*record.trouble);
    return writeTextPrivately(outboxRecordFile(folder),
                              json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace macula::study
