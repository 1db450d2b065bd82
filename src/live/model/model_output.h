// A trained model as a file.
#pragma once

#include <cstddef>
#include <filesystem>

#include "base/result.h"
#include "pipeline/splat/train/trainer.h"

namespace macula::live {

// Fails with usage if the name has the ending of none of splat::kModelFormats.
Result<void> checkModelName(const std::filesystem::path& path);

// Likewise, and also for formats that keep the training.
Result<void> checkSplatsName(const std::filesystem::path& path);

// Whether training can resume from the file: .macula holds all it needs, other formats the splats alone.
bool holdsTraining(const std::filesystem::path& path);

// Writes the format of the name's ending. `displayColours` writes display-encoded colours, for programs that
// ignore linear light; files that hold a training ignore it. Returns how many splats had numbers that the
// format cannot hold, and were clamped.
Result<std::size_t> writeTrained(const std::filesystem::path& path, const splat::TrainingState& state,
                                 bool displayColours);

// Likewise, but the splats alone; fails with usage for a format that holds a training.
Result<std::size_t> writeSplats(const std::filesystem::path& path, const splat::Splats& splats,
                                bool displayColours);

}  // namespace macula::live
