// The largest value of any interval of a table, in constant time: the sparse table of Bender and
// Farach-Colton (2000).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace macula {

class RangeMax {
  public:
    // O(n log n) time and memory; n = values.size() at least 1.
    explicit RangeMax(std::span<const float> values);

    // Exact maximum over [first, last], both within the table, first <= last.
    float operator()(std::size_t first, std::size_t last) const;

  private:
    std::vector<std::vector<float>> levels_;  // levels_[n][i] = max over [i, i + 2^n)
};

}  // namespace macula
