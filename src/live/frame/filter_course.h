// When a picture of all pixels that gets samples is shown again, and whether filtered: the rules alone,
// without device or clock.
//
// The filter goes on until the noise of the plain mean cannot be seen. What it blurs is an error by then, and
// what noise it takes out is none: plain means take over, and the change cannot be seen either. Each time
// that it runs it takes as long as a sample or two, which the picture does not get: so it runs when there are
// twice as many samples, or when it would take no more than an eighth of the time since it ran last.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>

namespace macula::app {

class FilterCourse {
  public:
    using TimePoint = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::milliseconds kNewsInterval{100};  // more news cannot be seen
    static constexpr double kTimesOfFilter = 8.0;                   // between two pictures

    // Another picture, which is worth showing from so many samples of a pixel on. `filters`: there is a
    // filter for it.
    void begin(std::uint64_t firstSamples, bool filters);
    // Shows plain means from now on, because the device has no memory for the filter.
    void doWithoutFilter(std::uint64_t firstSamples);

    // Whether the noise of the plain mean is below that threshold, 0 to 1 as displayed. Once it cannot be
    // seen, it stays so: it falls with each sample.
    void noiseIs(bool isBelow, double threshold);
    // Whether the picture that is shown next is filtered.
    bool isFiltered() const { return filters_ && !isUnseen_; }
    // Whether noise may be seen in the plain mean.
    bool isNoisy() const { return !isUnseen_; }

    // Whether it is shown with so many samples of a pixel on average.
    bool isDue(double samples, TimePoint now) const;
    // It was shown; the filter took so long.
    void showed(double samples, double filterMs, TimePoint now);
    bool isWorthShowing() const { return shownSamples_ > 0.0; }

  private:
    std::uint64_t firstSamples_ = 1;
    bool filters_ = false;
    bool isUnseen_ = false;
    double shownSamples_ = 0.0;  // 0: it was not shown yet
    double filterMs_ = 0.0;
    TimePoint shownAt_{};
};

}  // namespace macula::app
