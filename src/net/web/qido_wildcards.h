// A search that archives understand which do not decode addresses, as Orthanc 1.10 does not: for those
// a caret, a blank or an umlaut in a value never matches.
#pragma once

#include <optional>

#include "net/archive/query.h"

namespace macula::net {

// The query with wildcards for all characters that would be encoded; nothing where there are none. It finds
// more: what it finds must be compared with the query (matchesTexts).
std::optional<StudyQuery> withWildcards(const StudyQuery& query);

}  // namespace macula::net
