// How often the values of a volume are, to be shown behind a curve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::app {

// Of equal bins. A bin holds the values from its lower edge up to, and without, its upper one; the last holds
// that, too.
struct Bins {
    ValueRange range;  // in units: from the lowest edge to the highest; not empty
    std::size_t count = 1;
};

struct Histogram {
    Bins bins;
    std::vector<std::uint64_t> counts;  // one for each bin
    std::uint64_t below = 0;            // values outside of all bins
    std::uint64_t above = 0;
    std::size_t stride = 1;  // of the voxels as they are stored, each so many-th was counted

    double edge(std::size_t bin) const;  // the lower one, in units
};

// Bins over all values of the volume, each over the same number of stored ones, so that none is high only
// because more of them fall into it; at most 16384. Nothing when all of the volume is padding.
std::optional<Bins> binsOf(const Volume& volume);

// About so many voxels say as much as all 300 million of a large volume.
inline constexpr std::size_t kMostCounted = 2'000'000;

// Padding is left out. All voxels are counted where there are at most `most`; else they are taken with a
// stride that has no divisor with the length of an axis in common: no row or column is preferred. Fails with
// `cancelled` only.
Result<Histogram> histogramOf(const Volume& volume, const Bins& bins, const CancelToken& token = {},
                              std::size_t most = kMostCounted);

// The edge of a bin below which at least that fraction, 0 to 1, of what was counted lies.
double percentile(const Histogram& histogram, double fraction);

// For `columns` of equal width over the range `shown`: of the highest bin that the column touches,
// log(1 + count) as a part of that of the highest bin of all, 0 to 1.
std::vector<double> logHeights(const Histogram& histogram, const ValueRange& shown, std::size_t columns);

}  // namespace macula::app
