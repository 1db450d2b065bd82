#include "slices/slab_steps.h"

#include <algorithm>
#include <cmath>

namespace macula::slices {

namespace {

double wantedStepMm(const Volume& volume, const SlicePlane& plane) {
    const glm::dvec3 sides = volume.spacingMm();
    const double longest = 0.5 * std::min({sides.x, sides.y, sides.z});
    const double apart = stepMm(volume, plane);
    constexpr double kRounding = 1e-6;  // a quotient may miss a whole number by this
    return apart / std::max(1.0, std::ceil(apart / longest - kRounding));
}

}  // namespace

std::vector<SlabStep> stepsThrough(const Volume& volume, const SlicePlane& plane, double thicknessMm) {
    if (!(thicknessMm > 0.0)) return {SlabStep{}};
    const DepthRange depths = depthsMm(volume, plane);
    double step = wantedStepMm(volume, plane);
    // Keeps the depth finite, however thick the slab is.
    const double half =
        std::min(thicknessMm / 2.0, std::max(std::abs(depths.lowMm), std::abs(depths.highMm)) + 2.0 * step);
    const double from = std::max(-half, depths.lowMm - step);
    const double to = std::min(half, depths.highMm + step);
    if (!(from <= to)) return {};  // the volume is elsewhere
    step = std::max(step, (to - from) / kMostSlabSteps);

    const double whole = std::floor(half / step);  // steps to either side
    const double rest = std::max(half - whole * step, 0.0);
    const bool hasRest = rest > 1e-9 * step;
    const double weightOfLast = whole > 0.0 ? (step + rest) / 2.0 : rest;
    const double first = std::ceil(std::max(from / step, -whole));
    const double last = std::floor(std::min(to / step, whole));
    // No steps for a plane that is too far away for a double.
    const double between = last - first;
    const bool isCount = between >= 0.0 && between <= 2.0 * kMostSlabSteps;
    const int count = isCount ? static_cast<int>(between) + 1 : 0;

    std::vector<SlabStep> steps;
    if (hasRest && from == -half) steps.push_back({-half, rest / 2.0});
    for (int n = 0; n < count; ++n) {
        const double number = first + n;
        steps.push_back({number * step, std::abs(number) < whole ? step : weightOfLast});
    }
    if (hasRest && to == half) steps.push_back({half, rest / 2.0});
    return steps;
}

}  // namespace macula::slices
