#include "net/archive/query_check.h"

#include <algorithm>

#include "net/archive/file_meta.h"

namespace macula::net {

namespace {

bool isDate(const std::string& text) {
    constexpr std::size_t kDigits = 8;
    return text.size() == kDigits && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

Result<void> checkUid(const std::string& uid) {
    if (isUid(uid)) return {};
    return Error{ErrorCode::usage,
                 Text("The identifier of a study, series or image is malformed."),
                 {},
                 Text("It has at most 64 digits and dots: choose from the archive's list instead.")};
}

Result<void> checkQuery(const StudyQuery& query) {
    for (const std::string* date : {&query.patientBirthDate, &query.dateFrom, &query.dateTo}) {
        if (!date->empty() && !isDate(*date))
            return Error{ErrorCode::usage,
                         Text("A date of the search is malformed."),
                         {},
                         Text("Write year, month and day with eight digits.")};
    }
    return query.studyInstanceUid.empty() ? Result<void>() : checkUid(query.studyInstanceUid);
}

Error tooManyInstances() {
    return {ErrorCode::archiveNotUsable,
            Text("The archive lists more than {} images of one study.", kMostInstancesOfStudy),
            {},
            Text("Ask for its series one by one.")};
}

}  // namespace macula::net
