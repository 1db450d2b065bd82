// The state of an optimiser (optimizer.h), apart from its options.
#pragma once

#include <cstdint>
#include <vector>

namespace macula::splat {

// With this and the parameters, training continues bit for bit. Moments of positions are along the axes of
// their splat.
struct OptimizerState {
    std::uint64_t stepsDone = 0;       // of the model: the learning rates decay with it
    std::vector<std::uint32_t> steps;  // number of steps of each splat
    std::vector<float> first;          // moments; component k of splat i at k * steps.size() + i
    std::vector<float> second;
};

}  // namespace macula::splat
