// The options of the trainer (trainer.h). All of them are part of a training state (training_state.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/splat/model/density_control.h"
#include "pipeline/splat/train/loss_options.h"
#include "pipeline/splat/train/optimizer_options.h"

namespace macula::splat {

// From step `firstStep` on, each side of the pictures is halved `halvings` times, and they are compared by
// `measure`.
struct TrainingStage {
    std::uint64_t firstStep = 0;
    int halvings = 0;
    LossMeasure measure = LossMeasure::similar;
};

// A new option must be entered in option_lines.cpp too, which does not compile until then.
struct TrainerOptions {
    std::uint32_t capacity = 0;  // room for splats; 0: for as many as the model has
    std::uint32_t seed = 0;
    OptimizerOptions optimizer;
    LossOptions loss;
    DensityOptions density;
    std::vector<TrainingStage> stages{{.firstStep = 0, .halvings = 2},
                                      {.firstStep = 300, .halvings = 1},
                                      {.firstStep = 600, .halvings = 0}};
    double keepEveryMs = 2000.0;  // of training between copies of the state for Trainer::lastGood
    std::string key;  // what the pictures show: volume, preset, clip, lights. The caller sets and compares
                      // it; the trainer only keeps it
};

}  // namespace macula::splat
