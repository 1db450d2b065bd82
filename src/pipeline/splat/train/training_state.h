// Everything needed to continue training exactly where it stopped, on the host.
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

// Raised whenever a change of the trainer would make it continue differently from the same state.
inline constexpr std::uint32_t kTrainerVersion = 7;

// Training continues as a function of this state and the device alone: random numbers depend on the seed and
// the number of the step.
struct TrainingState {
    // A training view, shared with the trainer, and its loss when it was last drawn.
    struct View {
        std::shared_ptr<const TrainingView> given;
        double loss = -1.0;  // below 0: it was never drawn
        double l1 = 0.0;
    };

    std::uint32_t trainerVersion = kTrainerVersion;
    TrainerOptions options;  // `capacity` is that of the trainer
    std::uint64_t steps = 0;
    Splats splats;
    OptimizerState optimizer;
    std::vector<shared::SplatStatistics> statistics;  // for each splat, since the trainer last cleared them
    std::vector<View> views;                          // in the order in which they were added

    // Fails with inputNotUsable when it is of another version of the trainer, or its parts do not match.
    // Trainer::addView checks the content of each view.
    Result<void> validate() const;
};

}  // namespace macula::splat
