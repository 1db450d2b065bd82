// Reports how the render thread spent its time, as a table for people and as JSON for measurements.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/timeline.h"

namespace macula::live {

// A list of {stage, times, ms, waitedMs, longestMs}, by total ms, largest first. If `watchedMs` exceeds their
// sum, a last entry holds the rest, in which the thread was idle.
nlohmann::ordered_json toJson(std::vector<StageTimes> stages, double watchedMs = 0.0);

// The list as a table, without stages below a thousandth of the total time.
std::string tableOf(const nlohmann::ordered_json& times);

}  // namespace macula::live
