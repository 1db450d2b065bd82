// The optimiser's state after splats were regrouped.
#pragma once

#include <cstddef>

#include "pipeline/splat/model/density_control.h"
#include "pipeline/splat/train/optimizer_state.h"

namespace macula::splat {

// Splats that stay keep their state in `known`; new ones start from 0. `components`: numbers of a splat.
OptimizerState regroupedState(const OptimizerState& known, const Regrouped& regrouped,
                              std::size_t components);

}  // namespace macula::splat
