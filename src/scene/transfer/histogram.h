// The histogram of a volume's values, for display behind a curve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::scene {

// Bins of equal width. A bin includes its lower edge and excludes its upper one; the last includes both.
struct Bins {
    ValueRange range;  // in units: from the lowest edge to the highest; not empty
    std::size_t count = 1;
};

struct Histogram {
    Bins bins;
    std::vector<std::uint64_t> counts;  // one for each bin
    std::uint64_t below = 0;            // values outside of all bins
    std::uint64_t above = 0;
    std::size_t stride = 1;  // every stride-th voxel in storage order was counted

    double edge(std::size_t bin) const;  // the lower one, in units
};

// Bins over all values of the volume, at most 16384. For stored16 each covers as many stored values as the
// others, so that none is high only because it covers more. Nothing when all of the volume is padding.
std::optional<Bins> binsOf(const Volume& volume);

// This many voxels represent even a volume of 300 million.
inline constexpr std::size_t kMostCounted = 2'000'000;

// Leaves padding out. Counts all voxels if there are at most `most`; otherwise every stride-th, with a stride
// coprime to the length of each axis, so that no row or column is preferred. Fails with `cancelled` only.
Result<Histogram> histogramOf(const Volume& volume, const Bins& bins, const CancelToken& token = {},
                              std::size_t most = kMostCounted);

// The lowest bin edge with at least that fraction, 0 to 1, of the counted values below it, or the last edge.
double percentile(const Histogram& histogram, double fraction);

// Heights from 0 to 1 for `columns` of equal width over the range `shown`: log(1 + count) of the highest bin
// that the column touches, divided by that of the highest bin of all.
std::vector<double> logHeights(const Histogram& histogram, const ValueRange& shown, std::size_t columns);

}  // namespace macula::scene
