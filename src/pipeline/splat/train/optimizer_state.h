// All that an optimiser (optimizer.h) knows beside its options.
#pragma once

#include <cstdint>
#include <vector>

namespace macula::splat {

// With it and the parameters training goes on bit for bit. Moments of positions are along the axes of their
// splat.
struct OptimizerState {
    std::uint64_t stepsDone = 0;       // of the model: the position's rate decays by it
    std::vector<std::uint32_t> steps;  // by splat
    std::vector<float> first;          // moments; component k of splat i at k * steps.size() + i
    std::vector<float> second;
};

}  // namespace macula::splat
