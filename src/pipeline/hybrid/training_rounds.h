// How a model trains whose end nobody knows: in rounds, in each of which rates fall, and which end early when
// that is of no more use.
#pragma once

#include <cstdint>

#include "pipeline/splat/trainer_options.h"

namespace macula::hybrid {

// Whether all rates have come to their last values.
bool isSettled(const splat::TrainerOptions& options, std::uint64_t stepsDone);

// Rates go on from where they are after `stepsDone`, without a jump, and come to the same last values within
// `steps` steps; splats are neither split nor removed any more, and pictures are whole.
splat::TrainerOptions settling(splat::TrainerOptions options, std::uint64_t stepsDone, std::uint64_t steps);

}  // namespace macula::hybrid
