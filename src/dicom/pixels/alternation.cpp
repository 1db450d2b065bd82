#include "dicom/pixels/alternation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/parallel.h"
#include "dicom/pixels/slice_samples.h"

namespace macula::dicom {

namespace {

// The power of the alternating sum of second differences d along the slices, relative to the power of all:
// 16/6 for white noise and for a single odd value, 2 for a step, less for smooth values, and as much as the
// number of differences if slices alternate.
constexpr double kMostPowerByChance = 5.0;
constexpr std::size_t kLeastSlices = 8;

// The median second difference of neighbours in a row, without those of flat areas, which are 0; edges are
// too few to matter. 0 if almost everything is flat.
double noiseOf(std::span<const float> slice) {
    std::vector<float> differences;
    differences.reserve(slice.size() / 2);
    for (std::size_t run = 0; run + SliceSamples::kRun <= slice.size(); run += SliceSamples::kRun) {
        for (std::size_t i = run; i + 2 < run + SliceSamples::kRun; ++i) {
            const float d = std::abs(slice[i] - 2.0f * slice[i + 1] + slice[i + 2]);
            if (d > 0.0f) differences.push_back(d);  // false for NaN
        }
    }
    if (differences.size() < SliceSamples::kRun) return 0.0;
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::ranges::nth_element(differences, middle);
    return double{*middle};
}

}  // namespace

bool alternates(std::span<const std::span<const float>> slices) {
    if (slices.size() < kLeastSlices) return false;
    const std::size_t count = slices[0].size();
    std::vector<double> sums(count);
    std::vector<double> powers(count);
    for (std::size_t k = 1; k + 1 < slices.size(); ++k) {
        const double sign = k % 2 == 0 ? 1.0 : -1.0;
        for (std::size_t at = 0; at < count; ++at) {
            const double d =
                double{slices[k - 1][at]} - 2.0 * double{slices[k][at]} + double{slices[k + 1][at]};
            sums[at] += sign * d;
            powers[at] += d * d;
        }
    }
    double alternating = 0.0;
    double all = 0.0;
    for (std::size_t at = 0; at < count; ++at) {
        if (!std::isfinite(powers[at])) continue;  // padding
        alternating += sums[at] * sums[at];
        all += powers[at];
    }
    return alternating > kMostPowerByChance * all;
}

bool noiseAlternates(std::span<const std::span<const float>> slices) {
    if (slices.size() < kLeastSlices) return false;
    std::vector<double> noises(slices.size());
    parallelFor(slices.size(), [&](std::size_t k) { noises[k] = noiseOf(slices[k]); });
    // Interpolation along a helix changes noise by some percent from slice to slice, another kernel by more.
    constexpr double kLeastRatio = 1.25;
    std::array<std::size_t, 2> above{};  // counts of even slices and of odd ones
    std::array<std::size_t, 2> below{};
    for (std::size_t k = 1; k + 1 < noises.size(); ++k) {
        const double beside = std::sqrt(noises[k - 1] * noises[k + 1]);
        if (noises[k] > kLeastRatio * beside && beside > 0.0) ++above[k % 2];
        if (noises[k] * kLeastRatio < beside) ++below[k % 2];
    }
    const std::size_t fitting = std::max(above[0] + below[1], above[1] + below[0]);
    return 10 * fitting >= 9 * (noises.size() - 2);
}

}  // namespace macula::dicom
