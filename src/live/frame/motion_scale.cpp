#include "live/frame/motion_scale.h"

#include <algorithm>
#include <array>

namespace macula::live {

namespace {

constexpr std::array kScales{1, 2, 3, 4, 5, 6, 8, 10, 12, 16};
constexpr double kFinerOnlyBelow = 0.75;  // share of the budget
// Falling behind the hand is worse than a coarse frame, so a slower frame counts more than a faster one.
// Neither counts in full, because a single frame says little on a busy machine.
constexpr double kWeightOfSlower = 0.6;
constexpr double kWeightOfFaster = 0.3;

void moveTowards(double& estimate, double seen) {
    estimate += (seen > estimate ? kWeightOfSlower : kWeightOfFaster) * (seen - estimate);
}

}  // namespace

int scaledEdge(int windowEdge, int scale) {
    return std::max(1, (windowEdge + scale - 1) / scale);
}

MotionScale::MotionScale(double budgetMs, double nsPerPixelGuess)
    : budgetMs_(budgetMs), nsPerPixel_(nsPerPixelGuess) {}

void MotionScale::observe(int width, int height, double traceMs, double otherMs) {
    const double pixels = std::max(1.0, double(width) * height);
    moveTowards(nsPerPixel_, std::max(traceMs, 0.0) * 1e6 / pixels);
    moveTowards(otherMs_, std::max(otherMs, 0.0));
}

int MotionScale::choose(int windowWidth, int windowHeight) {
    const auto predictedMs = [&](int scale) {
        return otherMs_ +
               nsPerPixel_ * 1e-6 * scaledEdge(windowWidth, scale) * scaledEdge(windowHeight, scale);
    };
    int best = kScales.back();
    for (const int scale : kScales) {
        const bool finer = last_ != 0 && scale < last_;
        if (predictedMs(scale) <= budgetMs_ * (finer ? kFinerOnlyBelow : 1.0)) {
            best = scale;
            break;
        }
    }
    return last_ = best;
}

}  // namespace macula::live
