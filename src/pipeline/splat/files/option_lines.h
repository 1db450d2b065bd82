// The trainer's options as lines of text, "NAME VALUE", in files of training.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/train/trainer_options.h"

namespace macula::splat {

// A line for each option but the key, which may be any text. Numbers are written so that they read back
// exactly.
std::vector<std::string> linesOf(const TrainerOptions& options);

// Fails with inputNotUsable when a line is missing, twice, unknown or not understood: what would train
// otherwise than it did is no continuation. Whether the values make sense is for Trainer::create to judge.
Result<TrainerOptions> optionsOf(const std::vector<std::string>& lines);

}  // namespace macula::splat
