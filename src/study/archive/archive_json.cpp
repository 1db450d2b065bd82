#include "study/archive/archive_json.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace macula::study {

namespace {

using Json = nlohmann::ordered_json;

template <class Number>
Json numberOrNull(const std::optional<Number>& number) {
    return number ? Json(*number) : Json();
}

Json jsonOf(const net::FoundStudy& study) {
    return {{"studyInstanceUid", study.studyInstanceUid},
            {"date", study.date},
            {"time", study.time},
            {"description", study.description},
            {"accessionNumber", study.accessionNumber},
            {"studyId", study.studyId},
            {"patientName", study.patientName},
            {"patientId", study.patientId},
            {"patientBirthDate", study.patientBirthDate},
            {"patientSex", study.patientSex},
            {"referringPhysician", study.referringPhysician},
            {"modalities", study.modalities},
            {"seriesCount", numberOrNull(study.seriesCount)},
            {"instanceCount", numberOrNull(study.instanceCount)}};
}

Json jsonOf(const net::FoundSeries& series) {
    return {{"seriesInstanceUid", series.seriesInstanceUid},
            {"number", numberOrNull(series.number)},
            {"modality", series.modality},
            {"description", series.description},
            {"bodyPart", series.bodyPart},
            {"instanceCount", numberOrNull(series.instanceCount)}};
}

const char* wordOf(net::Commitment::State state) {
    switch (state) {
        case net::Commitment::State::committed:
            return "committed";
        case net::Commitment::State::refused:
            return "refused";
        case net::Commitment::State::unanswered:
            break;
    }
    return "unanswered";
}

Json jsonOf(const std::vector<Message>& messages) {
    Json list = Json::array();
    for (const Message& message : messages) {
        list.push_back({{"key", message.key},
                        {"sentence", message.sentence.english()},
                        {"action", message.action.english()}});
    }
    return list;
}

}  // namespace

Json toJson(const net::StudyAnswers& answers) {
    Json studies = Json::array();
    for (const net::FoundStudy& study : answers.studies) studies.push_back(jsonOf(study));
    return {
        {"studies", std::move(studies)}, {"isCutShort", answers.isCutShort}, {"unusable", answers.unusable}};
}

Json toJson(const std::vector<net::FoundSeries>& series) {
    Json list = Json::array();
    for (const net::FoundSeries& each : series) list.push_back(jsonOf(each));
    return list;
}

Json toJson(const FetchedStudy& fetched) {
    Json never = Json::array();
    for (const net::FoundInstance& instance : fetched.counts.never) never.push_back(instance.sopInstanceUid);
    return {{"folder", fetched.folder.string()},
            {"isComplete", fetched.isComplete},
            {"promised", fetched.counts.promised},
            {"kept", fetched.counts.kept},
            {"hadAlready", fetched.counts.hadAlready},
            {"refused", fetched.counts.refused},
            {"never", std::move(never)},
            {"bytes", fetched.counts.bytes},
            {"messages", jsonOf(fetched.messages)}};
}

Json toJson(const ReceivedStudy& received) {
    return {{"folder", received.folder.string()},
            {"senders", received.senders},
            {"kept", received.kept},
            {"hadAlready", received.hadAlready},
            {"refused", received.refused},
            {"otherContents", received.otherContents},
            {"instances", received.instances},
            {"messages", jsonOf(received.messages)}};
}

Json toJson(const net::Sent& sent) {
    Json notSent = Json::array();
    for (const net::NotSent& each : sent.notSent) {
        notSent.push_back(
            {{"file", each.file.string()}, {"why", each.why.english()}, {"advice", each.advice.english()}});
    }
    return {{"stored", sent.stored}, {"notSent", std::move(notSent)}};
}

Json toJson(const std::vector<net::Commitment>& commitments) {
    Json list = Json::array();
    for (const net::Commitment& each : commitments)
        list.push_back({{"file", each.file.string()},
                        {"state", wordOf(each.state)},
                        {"why", each.why.english()},
                        {"advice", each.advice.english()}});
    return list;
}

Json toJson(const std::vector<net::TestStep>& steps) {
    Json list = Json::array();
    for (const net::TestStep& step : steps) {
        list.push_back({{"name", step.name.english()},
                        {"passed", step.passed},
                        {"detail", step.detail.english()},
                        {"advice", step.advice.english()}});
    }
    return list;
}

}  // namespace macula::study
