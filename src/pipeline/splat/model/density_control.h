// Where splats are missing, and which are not needed: after some steps of training, splats that hardly show
// are removed, and those that the pictures pull in different directions are split. With a fixed number of
// splats that moves them to where there is more to be seen.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/splat/model/splats.h"
#include "shared/splat_frame.h"

namespace macula::splat {

struct DensityOptions {
    std::uint64_t firstStep = 100;  // after which it is first done
    std::uint64_t every = 100;      // steps
    std::uint64_t lastStep = 400;   // after which it is done no more
    // Removed are, of those that lay in a view since the last time, the ones that together have at most this
    // share of all that was shown.
    double unseenShare = 0.002;
    // Split are at most so many of those that remain, and never beyond the capacity of the model.
    double splitShare = 0.05;
};

// What becomes of a model: splat i of the new one is `source[i]` of the old, as it was or, where isNew[i]
// is not 0, one of the two halves of it, which has learnt nothing yet.
struct Regrouped {
    Splats splats;
    std::vector<std::uint32_t> source;
    std::vector<std::uint8_t> isNew;
};

// `statistics` has an entry for each splat. A function of its arguments.
Regrouped regroup(const Splats& splats, std::span<const shared::SplatStatistics> statistics,
                  const DensityOptions& options, std::uint32_t capacity);

}  // namespace macula::splat
