// What a peripheral model (peripheral_model.h) is, beside what lies on the device.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/result.h"
#include "pipeline/splat/train/training_state.h"

namespace macula::hybrid {

// All that it goes on with, on the host. Pictures are shared. peripheral_file.h keeps it in a file; of a
// .macula file that holds `training` only it goes on with that and `seenMm` of its scene, and other pictures
// are held out than before.
struct PeripheralState {
    splat::TrainingState training;                                    // its options.key says of what
    std::vector<std::shared_ptr<const splat::TrainingView>> heldOut;  // never learnt; it is judged by them
    // What is shown of it itself, which training may have made worse since; null: the splats of `training`.
    std::shared_ptr<const splat::Splats> shown;
    // The best that was shown; null: what is shown now.
    std::shared_ptr<const splat::Splats> best;
    // Of the shown model; a model that goes on with this state shows a later one.
    std::uint64_t generation = 0;
    Box seenMm;
    // That makes the light of what is shown as bright as what is traced (brightness_gauge.h).
    double gain = 1.0;
    std::uint64_t offered = 0;     // views that might have been held out
    std::uint64_t asked = 0;       // views asked for
    std::uint64_t roundViews = 0;  // learnt when the last round began
    splat::TrainerOptions first;   // how the training began, of the same key; capacity 0: that is not known

    // Fails with inputNotUsable as training.validate(), and when its parts do not belong together.
    Result<void> validate() const;
};

// Whether they can be those of a model: there is something to see, and it has some brightness.
bool areUsable(const Box& seenMm, double gain);

}  // namespace macula::hybrid
