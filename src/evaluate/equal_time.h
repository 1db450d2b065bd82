// Pure path tracing in a given time: how many samples, and which resolution, fit into that time.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace macula::evaluate {

// The time of a frame: a fixed part (guides, denoising, tone map), and the time of one sample of all pixels.
struct TracingCost {
    double fixedMs = 0.0;
    double perSampleMs = 0.0;
};

struct TracingBudget {
    glm::ivec2 sizePx{0};
    std::uint32_t samplesPerPixel = 1;

    bool operator==(const TracingBudget&) const = default;
};

// Finds the most samples of a frame of `sizePx` that fit into `budgetMs`. If not even one does, lowers the
// resolution until one does, at most to kLeastSidePx. `cost` is for the full size.
inline constexpr int kLeastSidePx = 8;
TracingBudget affordable(const TracingCost& cost, double budgetMs, const glm::ivec2& sizePx);

// The length of the traced sides over that of the full ones.
double resolutionShareOf(const TracingBudget& budget, const glm::ivec2& sizePx);

// The cost for the full size, estimated from the times of a frame of budget.sizePx.
TracingCost costOfWhole(double traceMs, double otherMs, const TracingBudget& budget,
                        const glm::ivec2& sizePx);

}  // namespace macula::evaluate
