#include "study/documents/document_json.h"

#include <string_view>

#include "dicom/documents/document_text.h"

namespace macula::study {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(const CodedName& code) {
    return {{"value", code.value}, {"scheme", code.scheme}, {"meaning", code.meaning}};
}

Json toJson(const dicom::DocumentReference& reference) {
    Json json{{"sopClassUid", reference.sopClassUid}, {"sopInstanceUid", reference.sopInstanceUid}};
    if (!reference.frames.empty()) json["frames"] = reference.frames;
    return json;
}

Json toJson(const dicom::DocumentEntry& entry) {
    Json json{{"depth", entry.depth}};
    if (!entry.place.empty()) json["place"] = entry.place;
    if (!entry.type.empty()) json["type"] = entry.type;
    json["heading"] = headingOf(entry).english();
    json["value"] = entry.value.english();
    if (!entry.name.value.empty()) json["name"] = toJson(entry.name);
    if (!entry.code.value.empty()) json[entry.type == "NUM" ? "unit" : "code"] = toJson(entry.code);
    if (entry.number) json["number"] = *entry.number;
    for (const dicom::DocumentReference& each : entry.references) json["references"].push_back(toJson(each));
    if (entry.points) {
        json["shape"] = entry.points->type;
        json[entry.points->isInSpace ? "pointsMm" : "pointsPx"] = entry.points->numbers;
        if (entry.points->isInSpace) json["frameOfReferenceUid"] = entry.points->frameOfReferenceUid;
    }
    return json;
}

std::string_view nameOf(dicom::StudyDocument::Kind kind) {
    using Kind = dicom::StudyDocument::Kind;
    switch (kind) {
        case Kind::report:
            return "report";
        case Kind::keyObjects:
            return "keyObjects";
        case Kind::plan:
            return "plan";
        case Kind::file:
            return "file";
    }
    return "report";
}

}  // namespace

nlohmann::ordered_json toJson(const dicom::StudyDocument& document) {
    Json json{{"kind", nameOf(document.kind)},
              {"kindName", document.kindName.english()},
              {"title", document.title.english()},
              {"sopClassUid", document.sopClassUid},
              {"sopInstanceUid", document.sopInstanceUid},
              {"studyInstanceUid", document.studyInstanceUid},
              {"patientName", document.patientName},
              {"patientId", document.patient.id},
              {"date", document.date},
              {"time", document.time},
              {"verified", document.isVerified},
              {"status", Json::array()},
              {"notes", Json::array()},
              {"entries", Json::array()}};
    for (const Text& each : document.status) json["status"].push_back(each.english());
    for (const Text& each : document.notes) json["notes"].push_back(each.english());
    for (const dicom::DocumentEntry& each : document.entries) json["entries"].push_back(toJson(each));
    if (document.contents)
        json["file"] = {{"mimeType", document.contents->mimeType}, {"bytes", document.contents->bytes}};
    return json;
}

}  // namespace macula::study
