// The addresses of searches (QIDO-RS, PS3.18 10.6.1) and of what an archive sends (WADO-RS, 10.4).
#pragma once

#include <string>

#include "base/result.h"
#include "net/archive/query.h"

namespace macula::net {

// Fails with usage where a date or an identifier of the query is malformed. Without limit and offset.
Result<std::string> studiesUrl(const std::string& service, const StudyQuery& query);

// Identifiers that archives answer with are valid, those of people need not be: fails with usage.
Result<std::string> seriesUrl(const std::string& service, const std::string& studyInstanceUid);
// Of the whole study where `seriesInstanceUid` is empty.
Result<std::string> instancesUrl(const std::string& service, const std::string& studyInstanceUid,
                                 const std::string& seriesInstanceUid);

std::string pageUrl(const std::string& url, std::size_t limit, std::size_t offset);

// What WADO-RS is to send: instances in the encoding in which the archive has them.
inline constexpr const char* kInstancesAsStored =
    "multipart/related; type=\"application/dicom\"; transfer-syntax=*";

// Every instance of the series, or one of them.
std::string retrieveUrl(const std::string& service, const std::string& studyInstanceUid,
                        const std::string& seriesInstanceUid, const std::string& sopInstanceUid = {});

}  // namespace macula::net
