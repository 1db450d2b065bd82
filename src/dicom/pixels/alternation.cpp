#include "dicom/pixels/alternation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace macula::dicom {

namespace {

// The power of the alternating sum of second differences d along the slices, over the power of all: 16/6 for
// white noise and for a single odd value, 2 for a step, less for what is smooth, and as large as there are
// differences when slices alternate.
constexpr double kMostPowerByChance = 5.0;
constexpr std::size_t kLeastSlices = 8;
constexpr std::size_t kMostColumns = 1 << 12;

template <class T>
bool alternatesIn(std::span<const std::span<const T>> slices) {
    if (slices.size() < kLeastSlices || slices[0].empty()) return false;
    // The stride is odd, no divisor of an image's usual width, so that not only one column of pixels is
    // looked at.
    const std::size_t stride = std::max<std::size_t>(1, slices[0].size() / kMostColumns) | 1u;
    double alternating = 0.0;
    double all = 0.0;
    for (std::size_t at = 0; at < slices[0].size(); at += stride) {
        double sum = 0.0;
        double power = 0.0;
        for (std::size_t k = 1; k + 1 < slices.size(); ++k) {
            const double d =
                double(slices[k - 1][at]) - 2.0 * double(slices[k][at]) + double(slices[k + 1][at]);
            sum += k % 2 == 0 ? d : -d;
            power += d * d;
        }
        if (!std::isfinite(power)) continue;
        alternating += sum * sum;
        all += power;
    }
    return alternating > kMostPowerByChance * all;
}

}  // namespace

bool alternates(std::span<const std::span<const std::uint16_t>> slices) {
    return alternatesIn(slices);
}

bool alternates(std::span<const std::span<const float>> slices) {
    return alternatesIn(slices);
}

}  // namespace macula::dicom
