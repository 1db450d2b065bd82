#include "evaluate/equal_time.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace macula::evaluate {

namespace {

constexpr double kTickMs = 1e-3;  // resolution of a clock: a measured 0 means at most this
constexpr double kMostSamples = 4096.0;

double pixels(const glm::ivec2& sizePx) {
    return double(sizePx.x) * double(sizePx.y);
}

}  // namespace

TracingBudget affordable(const TracingCost& cost, double budgetMs, const glm::ivec2& sizePx) {
    const double perSampleMs = std::max(cost.perSampleMs, kTickMs);
    const double samples = std::floor((budgetMs - cost.fixedMs) / perSampleMs);
    if (samples >= 1.0)
        return {.sizePx = sizePx,
                .samplesPerPixel = static_cast<std::uint32_t>(std::min(samples, kMostSamples))};
    const double share = std::sqrt(std::max(budgetMs, 0.0) / (std::max(cost.fixedMs, 0.0) + perSampleMs));
    const auto side = [&](int wholePx) {
        const auto reducedPx = static_cast<int>(std::floor(share * double(wholePx)));
        return std::clamp(reducedPx, std::min(kLeastSidePx, wholePx), wholePx);
    };
    return {.sizePx = {side(sizePx.x), side(sizePx.y)}, .samplesPerPixel = 1};
}

double resolutionShareOf(const TracingBudget& budget, const glm::ivec2& sizePx) {
    return std::sqrt(pixels(budget.sizePx) / pixels(sizePx));
}

TracingCost costOfWhole(double traceMs, double otherMs, const TracingBudget& budget,
                        const glm::ivec2& sizePx) {
    MACULA_CHECK(budget.samplesPerPixel > 0);
    const double larger = pixels(sizePx) / pixels(budget.sizePx);
    return {.fixedMs = otherMs * larger, .perSampleMs = traceMs * larger / double(budget.samplesPerPixel)};
}

}  // namespace macula::evaluate
