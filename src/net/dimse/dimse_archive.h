// An archive that speaks DIMSE.
#pragma once

#include <memory>
#include <string_view>

#include "base/result.h"
#include "net/archive/archive.h"
#include "net/archive/source.h"

namespace macula::net {

// PS3.5 6.2: no control characters and no backslash, and not blanks alone.
bool isAeTitle(std::string_view title);

// What of the settings of a DimsePeer cannot work; no connection is opened.
Result<void> checkDimsePeer(const DimsePeer& peer);

// The source holds a DimsePeer that has been checked.
std::unique_ptr<Archive> makeDimseArchive(const Source& source, const Secrets& secrets);

}  // namespace macula::net
