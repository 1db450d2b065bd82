// The state of a peripheral model (peripheral_model.h), without the device.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/result.h"
#include "pipeline/splat/train/training_state.h"

namespace macula::hybrid {

// All that a model needs to continue, on the host. Pictures are shared. peripheral_file.h keeps it in a file.
// From a .macula file that holds only `training`, a model can continue once `seenMm` is set; it then holds
// other pictures out than before.
struct PeripheralState {
    splat::TrainingState training;                                    // its options.key names the scene
    std::vector<std::shared_ptr<const splat::TrainingView>> heldOut;  // never learnt, only judged by
    // The shown splats, since training may have made the model worse; null: the splats of `training`.
    std::shared_ptr<const splat::Splats> shown;
    // The best splats that were shown; null: those shown now.
    std::shared_ptr<const splat::Splats> best;
    // Of the shown splats; a model that resumes from this state has a later one.
    std::uint64_t generation = 0;
    Box seenMm;
    // Makes the light of the shown splats as bright as traced pictures (brightness_gauge.h).
    double gain = 1.0;
    std::uint64_t offered = 0;     // views that might have been held out
    std::uint64_t asked = 0;       // views that the model asked for
    std::uint64_t roundViews = 0;  // learnt views when the last round began
    splat::TrainerOptions first;   // how the training began, with the same key; capacity 0: unknown

    // Fails with inputNotUsable as training.validate() does, and if its parts do not belong together.
    Result<void> validate() const;
};

// Whether a model can have them: the box has an extent, and the gain is above 0, both finite.
bool areUsable(const Box& seenMm, double gain);

}  // namespace macula::hybrid
