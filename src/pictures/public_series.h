// What a picture that leaves the machine says of its series.
#pragma once

#include <string>

namespace macula::app {

// Of StudyInput::seriesDigest: a digest keyed by this installation, which tells its own pictures of one
// series together, and others nothing. "phantom" is no secret; "unknown" where the key cannot be kept.
std::string publicSeries(const std::string& seriesDigest);

}  // namespace macula::app
