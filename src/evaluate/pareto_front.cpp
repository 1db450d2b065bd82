#include "evaluate/pareto_front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace macula::evaluate {

std::vector<std::size_t> paretoFront(std::span<const CostAndError> points) {
    std::vector<std::size_t> byCost;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) byCost.push_back(i);
    }
    std::stable_sort(byCost.begin(), byCost.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(points[a].cost, points[a].error) < std::tie(points[b].cost, points[b].error);
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();  // least error of all points that cost no more
    for (const std::size_t i : byCost) {
        if (points[i].error >= least) continue;
        least = points[i].error;
        front.push_back(i);
    }
    return front;
}

}  // namespace macula::evaluate
