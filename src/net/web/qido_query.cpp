#include "net/web/qido_query.h"

#include "net/archive/query_check.h"
#include "net/web/web_address.h"

namespace macula::net {

namespace {

// As a range of PS3.4 C.2.2.2.5.
std::string dateRange(const std::string& from, const std::string& to) {
    return from == to ? from : from + "-" + to;
}

}  // namespace

Result<std::string> studiesUrl(const std::string& service, const StudyQuery& query) {
    MACULA_TRY_VOID(checkQuery(query));
    std::string url = service + "/studies?";
    const auto add = [&](const char* name, const std::string& value) {
        if (!value.empty()) url += std::string(name) + "=" + queryEncoded(value) + "&";
    };
    add("PatientName", query.patientName);
    add("PatientID", query.patientId);
    add("PatientBirthDate", query.patientBirthDate);
    add("AccessionNumber", query.accessionNumber);
    add("StudyID", query.studyId);
    add("StudyInstanceUID", query.studyInstanceUid);
    add("StudyDate", dateRange(query.dateFrom, query.dateTo));
    add("ModalitiesInStudy", query.modality);
    add("StudyDescription", query.description);
    add("ReferringPhysicianName", query.referringPhysician);
    return url + "includefield=StudyDescription&fuzzymatching=false";
}

Result<std::string> seriesUrl(const std::string& service, const std::string& studyInstanceUid) {
    MACULA_TRY_VOID(checkUid(studyInstanceUid));
    return service + "/studies/" + studyInstanceUid + "/series?includefield=BodyPartExamined";
}

Result<std::string> instancesUrl(const std::string& service, const std::string& studyInstanceUid,
                                 const std::string& seriesInstanceUid) {
    MACULA_TRY_VOID(checkUid(studyInstanceUid));
    if (!seriesInstanceUid.empty()) MACULA_TRY_VOID(checkUid(seriesInstanceUid));
    const std::string series = seriesInstanceUid.empty() ? "" : "/series/" + seriesInstanceUid;
    return service + "/studies/" + studyInstanceUid + series + "/instances?includefield=SeriesInstanceUID";
}

std::string pageUrl(const std::string& url, std::size_t limit, std::size_t offset) {
    return url + "&limit=" + std::to_string(limit) + "&offset=" + std::to_string(offset);
}

std::string retrieveUrl(const std::string& service, const std::string& studyInstanceUid,
                        const std::string& seriesInstanceUid, const std::string& sopInstanceUid) {
    const std::string series = service + "/studies/" + studyInstanceUid + "/series/" + seriesInstanceUid;
    return sopInstanceUid.empty() ? series : series + "/instances/" + sopInstanceUid;
}

}  // namespace macula::net
