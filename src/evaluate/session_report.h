// What it costs to keep a model between runs, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "evaluate/store_round_trip.h"

namespace macula::evaluate {

// All that was found. What there was none of is null; `store` is there only where it was measured.
nlohmann::ordered_json toJson(const StoreRoundTrip& measured);

// Begins as `describe` of the study; no patient data.
nlohmann::ordered_json reportOf(const BenchStudy& study, const StoreRoundTripOptions& options,
                                const StoreRoundTrip& measured);

}  // namespace macula::evaluate
