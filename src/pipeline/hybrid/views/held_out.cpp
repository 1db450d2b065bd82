#include "pipeline/hybrid/views/held_out.h"

#include <algorithm>
#include <cmath>

namespace macula::hybrid {

namespace {

// Drops the last column and row of odd sizes: they show only the edge.
splat::TrainingView halved(const splat::TrainingView& view) {
    const glm::ivec2 from = view.view.sizePx;
    const glm::ivec2 to = from / 2;
    splat::TrainingView half = view;
    half.view.sizePx = to;
    half.view.focalPx *= 0.5;
    half.view.principalPx *= 0.5;
    half.pixels.clear();
    const auto at = [&](int x, int y) {
        return view.pixels[std::size_t(y) * std::size_t(from.x) + std::size_t(x)];
    };
    for (int y = 0; y < to.y; ++y)
        for (int x = 0; x < to.x; ++x)
            half.pixels.push_back(0.25f * (at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) +
                                           at(2 * x + 1, 2 * y + 1)));
    return half;
}

}  // namespace

bool isHeldOut(std::uint64_t number, std::size_t heldOut, double besideDeg) {
    constexpr std::size_t kByNumber = 4;  // the rest is reserved for sides that come late
    constexpr double kAnotherSide = 75.0;
    if (number == 0 || number == 3) return heldOut < kMostHeldOut;
    if (number % 7 == 0) return heldOut < kByNumber;
    return besideDeg > kAnotherSide && heldOut < kMostHeldOut && 3 * heldOut < number + 1;
}

splat::TrainingView reducedTo(splat::TrainingView view, int mostSidePx) {
    if (view.pixels.size() != std::size_t(view.view.sizePx.x) * std::size_t(view.view.sizePx.y)) return view;
    while (std::max(view.view.sizePx.x, view.view.sizePx.y) > mostSidePx &&
           std::min(view.view.sizePx.x, view.view.sizePx.y) >= 2)
        view = halved(view);
    return view;
}

double meanCoverage(const splat::TrainingView& view) {
    double sum = 0.0;
    double count = 0.0;
    for (const glm::vec4& pixel : view.pixels) {
        if (!std::isfinite(pixel.a)) continue;
        sum += double(pixel.a);
        count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
}

}  // namespace macula::hybrid
