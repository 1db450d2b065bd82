// The quality of the live picture over time, as JSON; docs/hybrid-frame.md says what each number is.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "evaluate/live_picture.h"

namespace macula::evaluate {

// All results; null for those that do not exist.
nlohmann::ordered_json toJson(const LivePictureReport& report);

// Begins with `describe` of the study; contains no patient data.
nlohmann::ordered_json reportOf(const BenchStudy& study, const LivePictureOptions& options,
                                const LivePictureReport& report);

}  // namespace macula::evaluate
