#include "study/outbox/outbox_json.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace macula::study {

namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const std::optional<Reason>& reason) {
    if (!reason) return {};
    return {{"why", reason->why.english()}, {"advice", reason->advice.english()}};
}

Json jsonOf(const Identity& patient) {
    return {{"patientName", patient.patientName},
            {"patientId", patient.patientId},
            {"birthDate", patient.birthDate},
            {"studyDate", patient.studyDate},
            {"studyDescription", patient.studyDescription}};
}

Json jsonOf(const OutboxEntry& entry) {
    Json patients = Json::array();
    for (const Identity& each : entry.record.patients) patients.push_back(jsonOf(each));
    Json files = Json::array();
    for (const OutboxFile& each : entry.record.files) {
        files.push_back({{"file", (entry.folder / each.name).string()}, {"refused", jsonOf(each.refused)}});
    }
    return {{"id", entry.id},
            {"state", nameOf(entry.state)},
            {"archive", entry.record.archive},
            {"address", entry.record.address},
            {"queuedAt", entry.record.queuedAt},
            {"tries", entry.record.tries},
            {"triedAt", entry.record.triedAt},
            {"trouble", jsonOf(entry.record.trouble)},
            {"patients", std::move(patients)},
            {"files", std::move(files)}};
}

}  // namespace

const char* nameOf(OutboxState state) {
    switch (state) {
        case OutboxState::waiting:
            return "waiting";
        case OutboxState::sending:
            return "sending";
        case OutboxState::refused:
            return "refused";
        case OutboxState::damaged:
            return "damaged";
    }
    return "";
}

Json toJson(const std::vector<OutboxEntry>& entries) {
    Json list = Json::array();
    for (const OutboxEntry& each : entries) list.push_back(jsonOf(each));
    return list;
}

Json toJson(const QueueSent& sent) {
    Json json{{"stored", sent.stored}, {"refused", sent.refused}, {"left", sent.left}};
    json["trouble"] = sent.trouble ? Json{{"why", sent.trouble->message.english()},
                                          {"advice", sent.trouble->hint.english()}}
                                   : Json();
    return json;
}

}  // namespace macula::study
