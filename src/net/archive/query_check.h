// What a query must be before it is sent: many archives answer a malformed one with nothing, as if there were
// no such study.
#pragma once

#include <cstddef>
#include <string>

#include "base/result.h"
#include "net/archive/query.h"

namespace macula::net {

// The most instances that a list of one study may have.
inline constexpr std::size_t kMostInstancesOfStudy = 200'000;

// Fails with usage where a date is not YYYYMMDD, or the UID is none.
Result<void> checkQuery(const StudyQuery& query);
// Fails with usage.
Result<void> checkUid(const std::string& uid);

// For a list that is longer than that.
Error tooManyInstances();

}  // namespace macula::net
