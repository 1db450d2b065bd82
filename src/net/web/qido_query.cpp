#include "net/web/qido_query.h"

#include <algorithm>

#include "net/archive/file_meta.h"
#include "net/web/web_address.h"

namespace macula::net {

namespace {

Error malformedUid() {
    return {ErrorCode::usage,
            Text("The identifier of a study, series or image is malformed."),
            {},
            Text("It has at most 64 digits and dots: choose from the archive's list instead.")};
}

bool isDate(const std::string& text) {
    constexpr std::size_t kDigits = 8;
    return text.size() == kDigits && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

// As a range of PS3.4 C.2.2.2.5.
std::string dateRange(const std::string& from, const std::string& to) {
    return from == to ? from : from + "-" + to;
}

}  // namespace

Result<std::string> studiesUrl(const std::string& service, const StudyQuery& query) {
    for (const std::string& date : {query.patientBirthDate, query.dateFrom, query.dateTo}) {
        if (!date.empty() && !isDate(date))
            return Error{ErrorCode::usage,
                         Text("A date of the search is malformed."),
                         {},
                         Text("Write year, month and day with eight digits.")};
    }
    if (!query.studyInstanceUid.empty() && !isUid(query.studyInstanceUid)) return malformedUid();
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
    if (!isUid(studyInstanceUid)) return malformedUid();
    return service + "/studies/" + studyInstanceUid + "/series?includefield=BodyPartExamined";
}

Result<std::string> instancesUrl(const std::string& service, const std::string& studyInstanceUid,
                                 const std::string& seriesInstanceUid) {
    if (!isUid(studyInstanceUid)) return malformedUid();
    if (!seriesInstanceUid.empty() && !isUid(seriesInstanceUid)) return malformedUid();
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
