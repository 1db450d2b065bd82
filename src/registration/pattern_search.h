// Maximises a function of six numbers without derivatives: Hooke and Jeeves, "Direct search solution of
// numerical and statistical problems", J. ACM 8 (1961), then steps to the top of fitted paraboloids.
#pragma once

#include <array>
#include <functional>

namespace macula::registration {

using Parameters = std::array<double, 6>;

struct SearchRange {
    double firstStep = 1.0;
    double lastStep = 0.1;  // steps halve from firstStep down to this
    int mostCalls = 2000;
};

struct Highest {
    Parameters at{};
    double value = 0.0;
};

// Deterministic: the same function gets the same calls, about range.mostCalls at most, and up to 84 for
// paraboloids. `value` may be minus infinity. Ends early, with the best place so far, once `cancelled`
// returns true.
Highest patternSearch(const std::function<double(const Parameters&)>& value, const Parameters& start,
                      const SearchRange& range, const std::function<bool()>& cancelled);

}  // namespace macula::registration
