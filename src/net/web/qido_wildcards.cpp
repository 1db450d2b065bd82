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

}  // namespace macula::net
