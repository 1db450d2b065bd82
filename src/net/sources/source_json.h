// A source as JSON, as it stands in the files of sources (docs/pacs.md).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "net/archive/source.h"

namespace macula::net {

// {"version": 1, "sources": [{"name": …, "dimse": {…} or "dicomweb": {…}}]}. Fails with inputNotUsable for
// what is not JSON, and for members that Macula does not know: a misspelt one would be a setting lost.
Result<std::vector<Source>> sourcesFromJson(std::string_view text);
nlohmann::json toJson(const std::vector<Source>& sources);
nlohmann::json toJson(const Source& source);

// Whether it has a name that can be typed, and an address that can work. archiveOf (connect.h) checks the
// rest, for which it needs the secrets. Says nothing of whether the archive is there.
Result<void> checkSource(const Source& source);

}  // namespace macula::net
