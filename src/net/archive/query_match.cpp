#include "net/archive/query_match.h"

#include <algorithm>
#include <string>

namespace macula::net {

namespace {

char smallLetter(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool matchesKey(const std::string& key, const std::string& value) {
    return key.empty() || matchesWildcards(key, value);
}

// A name may be written in several ways, with = between them.
bool matchesName(const std::string& key, std::string_view value) {
    if (key.empty() || matchesWildcards(key, value)) return true;
    while (!value.empty()) {
        const std::size_t end = std::min(value.find('='), value.size());
        if (matchesWildcards(key, value.substr(0, end))) return true;
        value.remove_prefix(std::min(end + 1, value.size()));
    }
    return false;
}

bool isWithin(const std::string& day, const std::string& from, const std::string& to) {
    if (from.empty() && to.empty()) return true;
    return !day.empty() && (from.empty() || day >= from) && (to.empty() || day <= to);
}

bool isEqual(const std::string& key, const std::string& value) {
    return key.empty() || key == value;
}

}  // namespace

bool matchesTexts(const StudyQuery& query, const FoundStudy& study) {
    return matchesName(query.patientName, study.patientName) &&
           matchesKey(query.patientId, study.patientId) &&
           matchesKey(query.accessionNumber, study.accessionNumber) &&
           matchesKey(query.studyId, study.studyId) && matchesKey(query.description, study.description) &&
           matchesName(query.referringPhysician, study.referringPhysician);
}

// Goes back to the last * alone, so that the time is bounded by the product of the lengths.
bool matchesWildcards(std::string_view key, std::string_view value) {
    std::size_t k = 0;
    std::size_t v = 0;
    std::size_t star = std::string_view::npos;
    std::size_t afterStar = 0;
    while (v < value.size()) {
        if (k < key.size() && key[k] == '*') {
            star = k++;
            afterStar = v;
        } else if (k < key.size() && (key[k] == '?' || smallLetter(key[k]) == smallLetter(value[v]))) {
            ++k;
            ++v;
        } else if (star != std::string_view::npos) {
            k = star + 1;
            v = ++afterStar;
        } else {
            return false;
        }
    }
    while (k < key.size() && key[k] == '*') ++k;
    return k == key.size();
}

bool matchesQuery(const StudyQuery& query, const FoundStudy& study) {
    return matchesTexts(query, study) && isEqual(query.studyInstanceUid, study.studyInstanceUid) &&
           isEqual(query.patientBirthDate, study.patientBirthDate) &&
           isWithin(study.date, query.dateFrom, query.dateTo) &&
           (query.modality.empty() || std::ranges::count(study.modalities, query.modality) > 0);
}

}  // namespace macula::net
