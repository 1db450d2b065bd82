// Where the time of the render thread went, for a person and for measurements.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/timeline.h"

namespace macula::app {

// A list of {stage, times, ms, waitedMs, longestMs}, the longest in sum first. Where `watchedMs` is more than
// they add up to, the rest is the last entry, of a thread that had nothing to do.
nlohmann::ordered_json toJson(std::vector<StageTimes> stages, double watchedMs = 0.0);

// The same as lines of a table, without those of less than a thousandth of the time.
std::string tableOf(const nlohmann::ordered_json& times);

}  // namespace macula::app
