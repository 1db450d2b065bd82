// A search that archives understand which do not decode addresses, as Orthanc 1.10 does not: for those
// a caret, a blank or an umlaut in a value never matches.
#pragma once

#include <optional>
#include <string_view>

#include "net/archive/query.h"

namespace macula::net {

// The query with wildcards for all characters that would be encoded; nothing where there are none. It finds
// more: what it finds must be compared with the query.
std::optional<StudyQuery> withWildcards(const StudyQuery& query);
bool isOfQuery(const StudyQuery& query, const FoundStudy& study);

// Whether a value matches a key with * and ? (PS3.4 C.2.2.2.4). Small and capital letters of ASCII are the
// same, since for most archives they are.
bool matchesWildcards(std::string_view key, std::string_view value);

}  // namespace macula::net
