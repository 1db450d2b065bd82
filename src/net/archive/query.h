// Queries that Macula sends to an archive (C-FIND, QIDO-RS), and the answers to them. All text is UTF-8.
//
// Both name patients: they are for the clinical display only, and never logged.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace macula::net {

// Keys of PS3.4 C.6.2.1 (study level). Empty keys match everything. Names, IDs, numbers and descriptions may
// hold the wildcards * and ? (PS3.4 C.2.2.2.4); archives differ in whether case matters.
struct StudyQuery {
    std::string patientName;  // components separated by ^
    std::string patientId;
    std::string patientBirthDate;  // YYYYMMDD
    std::string accessionNumber;
    std::string studyId;
    std::string studyInstanceUid;
    std::string dateFrom;  // YYYYMMDD; both ends are included, either may be empty
    std::string dateTo;
    std::string modality;  // one, as in CT
    std::string description;
    std::string referringPhysician;
    std::size_t mostAnswers = 10000;  // then the search ends, and says so: StudyAnswers::isCutShort
};

struct FoundStudy {
    std::string studyInstanceUid;
    std::string date;  // YYYYMMDD
    std::string time;  // HHMMSS, with or without a fraction
    std::string description;
    std::string accessionNumber;
    std::string studyId;
    std::string patientName;
    std::string patientId;
    std::string patientBirthDate;
    std::string patientSex;
    std::string referringPhysician;
    std::vector<std::string> modalities;
    std::optional<std::size_t> seriesCount;  // where the archive says it
    std::optional<std::size_t> instanceCount;
};

struct StudyAnswers {
    std::vector<FoundStudy> studies;  // in the archive's order; each UID once
    bool isCutShort = false;          // there are more than were asked for
    std::size_t unusable = 0;         // answers without a valid Study Instance UID, which are left out
};

struct FoundSeries {
    std::string seriesInstanceUid;
    std::optional<int> number;
    std::string modality;
    std::string description;
    std::string bodyPart;
    std::optional<std::size_t> instanceCount;
};

struct FoundInstance {
    std::string sopInstanceUid;
    std::string sopClassUid;  // empty where the archive does not say it
    std::string seriesInstanceUid;
    std::optional<int> number;
};

}  // namespace macula::net
