// What it costs to keep a model between runs, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "evaluate/session_benchmark.h"

namespace macula::evaluate {

// All that was found. What there was none of is null; `store` is there only where it was measured.
nlohmann::ordered_json toJson(const SessionBenchmark& measured);

// Begins as `describe` of the study; no patient data.
nlohmann::ordered_json reportOf(const BenchStudy& study, const SessionBenchmarkOptions& options,
                                const SessionBenchmark& measured);

}  // namespace macula::evaluate
