#include "net/web/qido_wildcards.h"

#include <algorithm>
#include <string>

#include "net/web/web_address.h"

namespace macula::net {

namespace {

// A letter beyond ASCII has several bytes, of which an archive may make one or more characters.
std::string wildcardsFor(std::string_view key) {
    std::string wide;
    for (const char c : key) {
        const bool isAscii = static_cast<unsigned char>(c) < 0x80;
        const char next = isPlainInQuery(c) ? c : isAscii ? '?' : '*';
        if (next != '*' || !wide.ends_with('*')) wide += next;
    }
    return wide;
}

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

}  // namespace

std::optional<StudyQuery> withWildcards(const StudyQuery& query) {
    StudyQuery wide = query;
    bool isOther = false;
    for (std::string StudyQuery::*key :
         {&StudyQuery::patientName, &StudyQuery::patientId, &StudyQuery::accessionNumber,
          &StudyQuery::studyId, &StudyQuery::description, &StudyQuery::referringPhysician}) {
        wide.*key = wildcardsFor(query.*key);
        isOther = isOther || !std::ranges::all_of(query.*key, isPlainInQuery);
    }
    return isOther ? std::optional(std::move(wide)) : std::nullopt;
}

bool isOfQuery(const StudyQuery& query, const FoundStudy& study) {
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

}  // namespace macula::net
