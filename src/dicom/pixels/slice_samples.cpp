#include "dicom/pixels/slice_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::dicom {

SliceSamples::SliceSamples(int columns, int rows, std::size_t slices) {
    // At most half of the memory that the pixels take, except for tiny images.
    constexpr std::size_t kFewRuns = 256;
    constexpr std::size_t kMostRuns = 1024;
    constexpr std::size_t kPixelsOfARun = 64;
    const std::size_t pixels = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    const std::size_t runs = std::clamp(pixels / kPixelsOfARun, kFewRuns, kMostRuns);
    if (pixels <= runs * kRun || columns < int(kRun)) {
        for (std::size_t at = 0; at + kRun <= pixels && runs_.size() < runs; at += kRun) runs_.push_back(at);
    } else {
        // Rows are evenly spaced, and columns follow the golden ratio, so that samples match no pattern of
        // the image.
        constexpr double kGolden = 0.6180339887498949;
        for (std::size_t r = 0; r < runs; ++r) {
            const std::size_t row = r * static_cast<std::size_t>(rows) / runs;
            const double place = std::fmod(kGolden * static_cast<double>(r), 1.0);
            const auto column = static_cast<std::size_t>(place * (columns - static_cast<int>(kRun) + 1));
            runs_.push_back(row * static_cast<std::size_t>(columns) + column);
        }
    }
    perSlice_ = runs_.size() * kRun;
    values_.assign(perSlice_ * slices, std::numeric_limits<float>::quiet_NaN());
}

void SliceSamples::take(std::size_t slice, std::span<const float> values) {
    float* to = values_.data() + slice * perSlice_;
    for (const std::size_t at : runs_) {
        for (std::size_t i = 0; i < kRun; ++i) *to++ = values[at + i];
    }
}

void SliceSamples::take(std::size_t slice, std::span<const std::uint16_t> stored, const UnitsFromStored& map,
                        const std::optional<StoredRange>& padding) {
    float* to = values_.data() + slice * perSlice_;
    for (const std::size_t at : runs_) {
        for (std::size_t i = 0; i < kRun; ++i) {
            const std::uint16_t cell = stored[at + i];
            *to++ = padding && padding->contains(cell) ? std::numeric_limits<float>::quiet_NaN()
                                                       : static_cast<float>(map(cell));
        }
    }
}

}  // namespace macula::dicom
