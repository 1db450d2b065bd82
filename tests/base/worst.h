// The worst of many differences.
#pragma once

#include <cmath>

namespace macula::test {

// The larger one; NaN when either is. std::max loses it, and a test that takes its worst by that cannot fail
// of one.
inline double worse(double soFar, double next) {
    if (std::isnan(soFar) || std::isnan(next)) return std::nan("");
    return next > soFar ? next : soFar;
}

}  // namespace macula::test
