// The time of day, as files note it.
#pragma once

#include <string>

namespace macula {

// In UTC, by ISO 8601: "2026-11-30T08:15:00Z".
std::string nowInUtc();
// With milliseconds, so that what is noted in turn sorts in turn: "2026-11-30T08:15:00.250Z".
std::string nowInUtcMs();

}  // namespace macula
