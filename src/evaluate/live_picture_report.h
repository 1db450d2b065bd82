// What the live picture is worth over time, as JSON; docs/hybrid-frame.md says what each number is.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "evaluate/live_picture.h"

namespace macula::evaluate {

// All that was found. What there was none of is null.
nlohmann::ordered_json toJson(const LivePictureReport& report);

// Begins as `describe` of the study; no patient data.
nlohmann::ordered_json reportOf(const BenchStudy& study, const LivePictureOptions& options,
                                const LivePictureReport& report);

}  // namespace macula::evaluate
