// What a peripheral model (peripheral_model.h) is, beside what lies on the device.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/frames.h"
#include "pipeline/splat/train/training_state.h"

namespace macula::hybrid {

class ModelShelf;

// All that it goes on with, on the host. Pictures are shared. A .macula file holds `training` only: what was
// read from one goes on with that and `seenMm` of its scene, and other pictures are held out than before.
struct PeripheralState {
    splat::TrainingState training;                                    // its options.key says of what
    std::vector<std::shared_ptr<const splat::TrainingView>> heldOut;  // never learnt; it is judged by them
    std::shared_ptr<const splat::Splats> before;  // still shown instead of it; null: it is shown itself
    std::string beforeKey;                        // of what `before` is
    std::uint64_t generation =
        0;  // of the shown model; a model that goes on with this state shows a later one
    Box seenMm;
    double gain = 1.0;             // that makes its light as bright as what is traced (brightness_gauge.h)
    std::uint64_t offered = 0;     // views that might have been held out
    std::uint64_t asked = 0;       // views asked for
    std::uint64_t roundViews = 0;  // learnt when the last round began
    splat::TrainerOptions first;   // how the training began
    std::shared_ptr<ModelShelf> shelf;  // models of what was shown before; null: none
};

}  // namespace macula::hybrid
