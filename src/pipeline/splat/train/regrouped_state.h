// What an optimiser knows of splats that were regrouped.
#pragma once

#include <cstddef>

#include "pipeline/splat/model/density_control.h"
#include "pipeline/splat/train/optimizer_state.h"

namespace macula::splat {

// Splats that stay keep what `known` has of them; the new ones begin anew. `components`: numbers of a splat.
OptimizerState regroupedState(const OptimizerState& known, const Regrouped& regrouped,
                              std::size_t components);

}  // namespace macula::splat
