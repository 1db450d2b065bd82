#include "pipeline/trace/pace.h"

#include <algorithm>

namespace macula::trace {

namespace {

constexpr double kFirst = 0.1;   // samples of a block in a millisecond: those of a very slow CPU
constexpr double kDenser = 0.5;  // the pace of adaptive passes, as a part of that of even ones
constexpr double kFaster = 2.0;  // at most so much larger is a dispatch than the one before

}  // namespace

double Pace::perMs(const Work& work) const {
    const auto known = perMs_.find(work);
    if (known != perMs_.end()) return known->second;
    if (!work.isAdaptive) return kFirst;
    return kDenser * perMs({.variant = work.variant, .bounces = work.bounces});
}

// Slower is believed at once, faster only by and by: a few blocks may be empty, and the next ones not.
void Pace::learn(const Work& work, double blockSamples, double ms) {
    if (!(blockSamples > 0.0)) return;  // no samples: nothing to learn from
    const double known = perMs(work);
    const double measured = blockSamples / std::max(ms, 1e-3);
    perMs_[work] = measured < known ? measured : std::min(0.5 * (known + measured), kFaster * known);
}

}  // namespace macula::trace
