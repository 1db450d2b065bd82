#include "pipeline/trace/pace.h"

#include <algorithm>

namespace macula::trace {

namespace {

constexpr double kDenser = 0.5;  // first guess of an adaptive pass's pace, as a fraction of an even one's

}  // namespace

double Pace::perMs(const Work& work) const {
    const auto known = perMs_.find(work);
    if (known != perMs_.end()) return known->second;
    if (!work.isAdaptive) return guess_.perMs;
    return kDenser * perMs({.variant = work.variant, .bounces = work.bounces, .leavesIdle = work.leavesIdle});
}

// Accepts a slower pace at once, but a faster one only gradually: a few blocks may be empty, and the next
// ones not.
void Pace::learn(const Work& work, double blockSamples, double ms) {
    if (!(blockSamples > 0.0)) return;  // no samples: nothing to learn from
    const double known = perMs(work);
    const double measured = blockSamples / std::max(ms, 1e-3);
    perMs_[work] = measured < known ? measured : std::min(0.5 * (known + measured), guess_.faster * known);
}

}  // namespace macula::trace
