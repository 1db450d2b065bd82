// Decides when a full-size picture is shown again while samples accumulate, and whether it is denoised. Holds
// the rules alone: no device, no clock.
//
// Denoising ends when the noise of the plain mean is too low to see: from then on it would only blur, and the
// switch to the plain mean is invisible. Each run of the denoiser takes the time of one or two samples. So it
// runs when the sample count has doubled, or when it takes at most an eighth of the time since it ran last.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>

namespace macula::live {

class FilterCourse {
  public:
    using TimePoint = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::milliseconds kNewsInterval{100};  // shortest time between pictures
    static constexpr double kTimesOfFilter = 8.0;                   // pause between runs, in run durations

    // Starts another picture, to be shown from `firstSamples` samples per pixel on. `filters`: the denoiser
    // can run on it.
    void begin(std::uint64_t firstSamples, bool filters);
    // Shows plain means from now on: the device lacks memory for the denoiser.
    void doWithoutFilter(std::uint64_t firstSamples);

    // Reports whether the noise of the plain mean is below `threshold` (0 to 1, as displayed). Invisible
    // noise (kUnseenNoise) stays invisible: it falls with each sample.
    void noiseIs(bool isBelow, double threshold);
    // Whether the next picture shown is denoised.
    bool isFiltered() const { return filters_ && !isUnseen_; }
    // Whether noise may be visible in the plain mean.
    bool isNoisy() const { return !isUnseen_; }

    // Whether to show the picture now, at a mean of `samples` per pixel.
    bool isDue(double samples, TimePoint now) const;
    // Reports that the picture was shown, and how long the denoiser took.
    void showed(double samples, double filterMs, TimePoint now);
    bool isWorthShowing() const { return shownSamples_ > 0.0; }

  private:
    std::uint64_t firstSamples_ = 1;
    bool filters_ = false;
    bool isUnseen_ = false;
    double shownSamples_ = 0.0;  // 0: not shown yet
    double filterMs_ = 0.0;
    TimePoint shownAt_{};
};

}  // namespace macula::live
