#include "live/frame/hand_rhythm.h"

#include <algorithm>

namespace macula::live {

void HandRhythm::input(TimePoint published, bool moves) {
    if (!moves) {
        last_.reset();
        gaps_.clear();
        return;
    }
    if (last_) {
        const auto gap = published - *last_;
        if (gap <= std::chrono::steady_clock::duration::zero()) return;  // the same input again
        if (gap > kPause)
            gaps_.clear();
        else
            gaps_.push_back(gap);
        if (gaps_.size() > kRemembered) gaps_.pop_front();
    }
    last_ = published;
}

double HandRhythm::leftMs(TimePoint now) const {
    // A single gap may be the pause between a press and the first movement.
    if (!last_ || gaps_.size() < 2) return 0.0;
    const auto due = *last_ + *std::min_element(gaps_.begin(), gaps_.end());
    return std::max(std::chrono::duration<double, std::milli>(due - now).count() - kReserveMs, 0.0);
}

}  // namespace macula::live
