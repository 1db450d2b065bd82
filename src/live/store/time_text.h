// Times of stored sessions, in milliseconds since 1970 (UTC), as ISO 8601.
#pragma once

#include <cstdint>
#include <string>

namespace macula::live {

std::string utcTime(std::int64_t sinceEpochMs);    // "2023-11-14T22:13:20.000Z"
std::string localTime(std::int64_t sinceEpochMs);  // "2023-11-14T23:13:20+01:00", local time

}  // namespace macula::live
