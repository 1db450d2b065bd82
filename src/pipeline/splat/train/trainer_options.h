// What the trainer (trainer.h) is told once. All of it is part of a state of training (training_state.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/splat/model/density_control.h"
#include "pipeline/splat/train/loss_options.h"
#include "pipeline/splat/train/optimizer_options.h"

namespace macula::splat {

// From step `firstStep` on pictures are 2^halvings times smaller, and are compared in that way.
struct TrainingStage {
    std::uint64_t firstStep = 0;
    int halvings = 0;
    LossMeasure measure = LossMeasure::similar;
};

// A new option is entered in option_lines.cpp too, which does not compile before.
struct TrainerOptions {
    std::uint32_t capacity = 0;  // splats there is room for; 0: as many as the model has
    std::uint32_t seed = 0;
    OptimizerOptions optimizer;
    LossOptions loss;
    DensityOptions density;
    std::vector<TrainingStage> stages{{.firstStep = 0, .halvings = 2},
                                      {.firstStep = 300, .halvings = 1},
                                      {.firstStep = 600, .halvings = 0}};
    double keepEveryMs = 2000.0;  // of training, between copies of the state for Trainer::lastGood
    std::string key;              // what the pictures show: volume, preset, clip, lights. The caller's, who
                                  // compares it; the trainer only keeps it
};

}  // namespace macula::splat
