// Path tracing alone in a given time: how many samples there is time for, and how fine a picture.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace macula::evaluate {

// The time of a frame: what it takes whatever its samples are (guides, denoising, tone map), and what one
// sample of all pixels takes.
struct TracingCost {
    double fixedMs = 0.0;
    double perSampleMs = 0.0;
};

struct TracingBudget {
    glm::ivec2 sizePx{0};
    std::uint32_t samplesPerPixel = 1;

    bool operator==(const TracingBudget&) const = default;
};

// Finds the most samples of a frame of `sizePx` that fit into `budgetMs`. Where not even one does, it lowers
// the resolution for one, if need be down to kLeastSidePx. `cost` is of the whole size.
inline constexpr int kLeastSidePx = 8;
TracingBudget affordable(const TracingCost& cost, double budgetMs, const glm::ivec2& sizePx);

// The share of the sides that is traced, 1 for all.
double resolutionShareOf(const TracingBudget& budget, const glm::ivec2& sizePx);

// The cost of the whole size, by what a frame took at its own.
TracingCost costOfWhole(double traceMs, double otherMs, const TracingBudget& budget,
                        const glm::ivec2& sizePx);

}  // namespace macula::evaluate
