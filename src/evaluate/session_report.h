// The cost of keeping a model between runs, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "evaluate/store_round_trip.h"

namespace macula::evaluate {

// All results; null for those that do not exist. `store` is present only if it was measured.
nlohmann::ordered_json toJson(const StoreRoundTrip& measured);

// Begins with `describe` of the study; contains no patient data.
nlohmann::ordered_json reportOf(const BenchStudy& study, const StoreRoundTripOptions& options,
                                const StoreRoundTrip& measured);

}  // namespace macula::evaluate
