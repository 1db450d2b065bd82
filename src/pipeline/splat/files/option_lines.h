// The trainer's options as lines of text, "NAME VALUE", in training files.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/train/trainer_options.h"

namespace macula::splat {

// A line for each option except the key, which may be any text. Numbers read back exactly.
std::vector<std::string> linesOf(const TrainerOptions& options);

// Fails with inputNotUsable when a line is missing, repeated, unknown or not understood, because training
// would then continue in another way. Trainer::create checks whether the values make sense.
Result<TrainerOptions> optionsOf(const std::vector<std::string>& lines);

}  // namespace macula::splat
