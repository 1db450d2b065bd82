#include "live/frame/filter_course.h"

#include <algorithm>

#include "live/frame/frame_input.h"

namespace macula::live {

void FilterCourse::begin(std::uint64_t firstSamples, bool filters) {
    *this = {};
    firstSamples_ = firstSamples;
    filters_ = filters;
}

void FilterCourse::doWithoutFilter(std::uint64_t firstSamples) {
    firstSamples_ = std::max(firstSamples_, firstSamples);
    filters_ = false;
}

void FilterCourse::noiseIs(bool isBelow, double threshold) {
    isUnseen_ = isUnseen_ || (isBelow && threshold <= kUnseenNoise);
}

bool FilterCourse::isDue(double samples, TimePoint now) const {
    if (samples < double(firstSamples_)) return false;
    if (!isWorthShowing()) return true;
    const std::chrono::duration<double, std::milli> since = now - shownAt_;
    if (since < kNewsInterval) return false;
    if (!isFiltered() || samples >= 2.0 * shownSamples_) return true;
    return samples > shownSamples_ && since.count() >= kTimesOfFilter * filterMs_;
}

void FilterCourse::showed(double samples, double filterMs, TimePoint now) {
    shownSamples_ = samples;
    filterMs_ = filterMs;
    shownAt_ = now;
}

}  // namespace macula::live
