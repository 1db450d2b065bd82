// Everything that is needed to go on with training exactly where it was, on the host.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/model/splats.h"
#include "pipeline/splat/train/optimizer_state.h"
#include "pipeline/splat/train/trainer_options.h"
#include "pipeline/splat/train/training_view.h"
#include "shared/splat_frame.h"

namespace macula::splat {

// Raised whenever the trainer would go on from the same state in another way.
inline constexpr std::uint32_t kTrainerVersion = 7;

// What training does next is a function of this state alone, and of the device: random numbers are of the
// seed and the number of the step.
struct TrainingState {
    // A picture to learn from, shared with the trainer, and what its loss was when it was last drawn.
    struct View {
        std::shared_ptr<const TrainingView> given;
        double loss = -1.0;  // below 0: it was never drawn
        double l1 = 0.0;
    };

    std::uint32_t trainerVersion = kTrainerVersion;
    TrainerOptions options;  // with the capacity that the trainer has
    std::uint64_t steps = 0;
    Splats splats;
    OptimizerState optimizer;
    std::vector<shared::SplatStatistics> statistics;  // by splat, since the trainer last cleared them
    std::vector<View> views;                          // in the order in which they were added

    // Fails with inputNotUsable when it is of another version of the trainer, or its parts do not belong
    // together. What single views hold is for Trainer::addView to judge.
    Result<void> validate() const;
};

}  // namespace macula::splat
