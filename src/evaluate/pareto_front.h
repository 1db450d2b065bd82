// The points that are worth their cost: no other is better in cost and error.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace macula::evaluate {

struct CostAndError {
    double cost = 0.0;
    double error = 0.0;
};

// The indices of the Pareto front: points for which no other has at most their cost and at most their error,
// and less of one. Cost ascends along the front, and error falls. Only the first of equal points is on it. A
// point whose cost or error is not finite is never on the front.
std::vector<std::size_t> paretoFront(std::span<const CostAndError> points);

}  // namespace macula::evaluate
