// What an archive says about instances that it was sent (STOW-RS, PS3.18 10.5.3 and I.2.2).
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "base/result.h"

namespace macula::net {

// Instances by their SOP Instance UID.
struct StowAnswer {
    std::unordered_set<std::string> stored;
    std::unordered_map<std::string, int> refused;  // with the Failure Reason; 0 where there is none
};

// Fails with archiveNotUsable where the text is not the JSON of DICOM. An empty text names nothing.
Result<StowAnswer> stowAnswerIn(std::string_view text);

struct StowReason {
    Text why;
    Text advice;
};
// Of the values of Failure Reason in PS3.18 Table I.2-2 and PS3.7 Annex C.
StowReason stowReason(int failureReason);

}  // namespace macula::net
