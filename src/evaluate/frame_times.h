// How long frames took, with percentiles and maximum, because a mean would hide a late frame.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace macula::evaluate {

// Upper edges of buckets. A frame belongs to the first bucket whose edge it does not exceed, or to an
// additional one after the last.
inline constexpr std::array kFrameBucketsMs{5.0,   10.0,  20.0,  30.0,  50.0,  75.0,
                                            100.0, 150.0, 200.0, 300.0, 500.0, 1000.0};

// Wall-clock times of single frames, from the first call until the device has drawn the frame.
struct FrameTimes {
    std::vector<double> ms;

    // Need at least one frame; `fraction` as in image::percentile.
    double percentileMs(double fraction) const;
    double maxMs() const;
    // Frames in each bucket.
    std::array<std::size_t, kFrameBucketsMs.size() + 1> histogram() const;
};

}  // namespace macula::evaluate
