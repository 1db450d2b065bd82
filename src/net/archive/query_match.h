// Whether a study matches a query, for studies that no archive has compared (PS3.4 C.2.2.2).
#pragma once

#include <string_view>

#include "net/archive/query.h"

namespace macula::net {

// All keys.
bool matchesQuery(const StudyQuery& query, const FoundStudy& study);
// The names, IDs, numbers and descriptions alone.
bool matchesTexts(const StudyQuery& query, const FoundStudy& study);

// Whether a value matches a key with * and ? (PS3.4 C.2.2.2.4). Small and capital letters of ASCII are the
// same, since for most archives they are.
bool matchesWildcards(std::string_view key, std::string_view value);

}  // namespace macula::net
