#include "evaluate/frame_times.h"

#include <algorithm>
#include <iterator>

#include "base/check.h"
#include "image/masked_metrics.h"

namespace macula::evaluate {

double FrameTimes::percentileMs(double fraction) const {
    return image::percentile(ms, fraction);
}

double FrameTimes::maxMs() const {
    MACULA_CHECK(!ms.empty());
    return *std::ranges::max_element(ms);
}

std::array<std::size_t, kFrameBucketsMs.size() + 1> FrameTimes::histogram() const {
    std::array<std::size_t, kFrameBucketsMs.size() + 1> frames{};
    for (const double each : ms) {
        const auto bucket = std::ranges::lower_bound(kFrameBucketsMs, each);
        ++frames.at(static_cast<std::size_t>(std::distance(kFrameBucketsMs.begin(), bucket)));
    }
    return frames;
}

}  // namespace macula::evaluate
