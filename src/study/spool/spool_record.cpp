#include "study/spool/spool_record.h"

#include <ctime>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/private_file.h"

namespace macula::study {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostBytesOfRecord = 64u << 20;

std::string textOf(const Json& json, const char* name) {
    const auto member = json.find(name);
    return member != json.end() && member->is_string() ? member->get<std::string>() : std::string();
}

std::vector<std::string> textsOf(const Json& json, const char* name) {
    std::vector<std::string> texts;
    const auto member = json.find(name);
    if (member == json.end() || !member->is_array()) return texts;
    for (const Json& each : *member) {
        if (each.is_string()) texts.push_back(each);
    }
    return texts;
}

// The members of a study's answer that are texts, and their names.
struct TextMember {
    const char* name;
    std::string net::FoundStudy::*text;
};
constexpr TextMember kTexts[] = {{"date", &net::FoundStudy::date},
                                 {"time", &net::FoundStudy::time},
                                 {"description", &net::FoundStudy::description},
                                 {"accessionNumber", &net::FoundStudy::accessionNumber},
                                 {"studyId", &net::FoundStudy::studyId},
                                 {"patientName", &net::FoundStudy::patientName},
                                 {"patientId", &net::FoundStudy::patientId},
                                 {"patientBirthDate", &net::FoundStudy::patientBirthDate},
                                 {"patientSex", &net::FoundStudy::patientSex},
                                 {"referringPhysician", &net::FoundStudy::referringPhysician}};

std::optional<std::size_t> countOf(const Json& json, const char* name) {
    const auto member = json.find(name);
    if (member == json.end() || !member->is_number_unsigned()) return std::nullopt;
    return member->get<std::size_t>();
}

net::FoundStudy foundStudyOf(const Json& json, const std::string& studyInstanceUid) {
    net::FoundStudy study;
    study.studyInstanceUid = studyInstanceUid;
    for (const TextMember& member : kTexts) study.*member.text = textOf(json, member.name);
    study.modalities = textsOf(json, "modalities");
    study.seriesCount = countOf(json, "seriesCount");
    study.instanceCount = countOf(json, "instanceCount");
    return study;
}

Json toJson(const net::FoundStudy& study) {
    Json json{{"modalities", study.modalities}};
    for (const TextMember& member : kTexts) json[member.name] = study.*member.text;
    if (study.seriesCount) json["seriesCount"] = *study.seriesCount;
    if (study.instanceCount) json["instanceCount"] = *study.instanceCount;
    return json;
}

}  // namespace

std::string timeOfRecord() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return std::string(text, length);
}

std::filesystem::path spoolRecordFile(const std::filesystem::path& folder) {
    return folder.parent_path() / (folder.filename().string() + ".json");
}

Result<SpoolRecord> readSpoolRecord(const std::filesystem::path& folder) {
    MACULA_TRY(const std::string text, readText(spoolRecordFile(folder), kMostBytesOfRecord));
    const Json json = Json::parse(text, nullptr, false);
    SpoolRecord record;
    if (json.is_object()) {
        record.studyInstanceUid = textOf(json, "studyInstanceUid");
        record.source = textOf(json, "source");
        record.senders = textsOf(json, "senders");
        record.promised = countOf(json, "promised").value_or(0);
        record.never = textsOf(json, "never");
        record.fetchedAt = textOf(json, "fetchedAt");
        record.isComplete = json.value("isComplete", Json()) == true;
        if (const auto study = json.find("study"); study != json.end() && study->is_object())
            record.asFound = foundStudyOf(*study, record.studyInstanceUid);
    }
    if (record.studyInstanceUid.empty())
        return Error{ErrorCode::inputNotUsable, Text("The notes on a fetched study are damaged."),
                     folder.string(), Text("Fetch the study again.")};
    return record;
}

Result<void> writeSpoolRecord(const std::filesystem::path& folder, const SpoolRecord& record) {
    Json json{{"version", 1},
              {"studyInstanceUid", record.studyInstanceUid},
              {"source", record.source},
              {"senders", record.senders},
              {"promised", record.promised},
              {"never", record.never},
              {"isComplete", record.isComplete},
              {"fetchedAt", record.fetchedAt}};
    if (record.asFound) json["study"] = toJson(*record.asFound);
    const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    return writeTextPrivately(spoolRecordFile(folder), text);
}

}  // namespace macula::study
