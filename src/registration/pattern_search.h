// Looks for the highest value of a function of six numbers, without derivatives: Hooke and Jeeves, "Direct
// search solution of numerical and statistical problems", J. ACM 8 (1961).
#pragma once

#include <array>
#include <functional>

namespace macula::registration {

using Parameters = std::array<double, 6>;

struct SearchRange {
    double firstStep = 1.0;
    double lastStep = 0.1;  // below this nothing is looked for
    int mostCalls = 2000;
};

struct Highest {
    Parameters at{};
    double value = 0.0;
};

// The same calls for the same function. `value` may be minus infinity where nothing is to be found. Ends
// early, with what it has, once `cancelled` says so.
Highest patternSearch(const std::function<double(const Parameters&)>& value, const Parameters& start,
                      const SearchRange& range, const std::function<bool()>& cancelled);

}  // namespace macula::registration
