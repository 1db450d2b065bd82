// How long frames took: a mean would hide the one that was late.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace macula::evaluate {

// Upper edges of buckets. A frame is in the first whose edge it does not exceed, or in the one behind the
// last.
inline constexpr std::array kFrameBucketsMs{5.0,   10.0,  20.0,  30.0,  50.0,  75.0,
                                            100.0, 150.0, 200.0, 300.0, 500.0, 1000.0};

// Wall-clock times of single frames, from the first call to when the device has drawn it.
struct FrameTimes {
    std::vector<double> ms;

    // Of at least one frame; `fraction` as image::percentile.
    double percentileMs(double fraction) const;
    double maxMs() const;
    // Frames in each bucket.
    std::array<std::size_t, kFrameBucketsMs.size() + 1> histogram() const;
};

}  // namespace macula::evaluate
