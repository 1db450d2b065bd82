// The name of a series in pictures that leave the machine.
#pragma once

#include <string>

namespace macula::pictures {

// Digest of LoadedStudy::seriesDigest with the key of this installation: it groups pictures of one series
// made here, and tells others nothing. Returns "phantom" unchanged; "unknown" if no key can be stored.
std::string publicSeries(const std::string& seriesDigest);

}  // namespace macula::pictures
