// Statistical verdicts, shared by tests. Thresholds are set so that a right implementation fails about once
// in 10^5 runs; seeds are fixed, so it does not fail at all.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

namespace macula::statistics {

// Pearson's statistic turned into a standard normal deviate (Wilson and Hilferty 1931). Cells that expect
// less than 5 are pooled.
inline double chiSquareDeviate(std::span<const double> observed, std::span<const double> expected) {
    double chi = 0.0;
    double pooledObserved = 0.0;
    double pooledExpected = 0.0;
    double cells = 0.0;
    const auto add = [&](double o, double e) {
        chi += (o - e) * (o - e) / e;
        cells += 1.0;
    };
    for (std::size_t i = 0; i < observed.size(); ++i) {
        if (expected[i] >= 5.0) {
            add(observed[i], expected[i]);
        } else {
            pooledObserved += observed[i];
            pooledExpected += expected[i];
        }
    }
    if (pooledExpected >= 5.0) add(pooledObserved, pooledExpected);
    const double n = cells - 1.0;
    return (std::cbrt(chi / n) - (1.0 - 2.0 / (9.0 * n))) / std::sqrt(2.0 / (9.0 * n));
}

inline constexpr double kDeviateLimit = 4.4;

}  // namespace macula::statistics
