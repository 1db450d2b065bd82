// Density control: every few training steps, removes splats that hardly show, and splits those that the
// pictures pull in different directions. With a fixed number of splats, this moves them to where more detail
// is visible.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/splat/model/splats.h"
#include "shared/splat_frame.h"

namespace macula::splat {

struct DensityOptions {
    std::uint64_t firstStep = 100;  // the step after which it is first done
    std::uint64_t every = 100;      // in steps
    std::uint64_t lastStep = 400;   // the last step after which it is done
    // Removes the splats with the least weight, of those that a view has shown since the last time: together
    // at most this share of all weight.
    double unseenShare = 0.002;
    // Splits at most this share of the remaining splats, and never beyond the capacity of the model.
    double splitShare = 0.05;
};

// The resulting model: its splat i is splat `source[i]` of the old one, unchanged or, if isNew[i] is not 0,
// one of its two halves, which has learnt nothing yet.
struct Regrouped {
    Splats splats;
    std::vector<std::uint32_t> source;
    std::vector<std::uint8_t> isNew;
};

// `statistics` has an entry for each splat. Depends only on its arguments.
Regrouped regroup(const Splats& splats, std::span<const shared::SplatStatistics> statistics,
                  const DensityOptions& options, std::uint32_t capacity);

}  // namespace macula::splat
