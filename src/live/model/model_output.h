// A trained model as a file.
#pragma once

#include <cstddef>
#include <filesystem>

#include "base/result.h"
#include "pipeline/splat/train/trainer.h"

namespace macula::app {

// usage for a name with the ending of none of splat::kModelFormats.
Result<void> checkModelName(const std::filesystem::path& path);

// The same for a format that keeps no training.
Result<void> checkSplatsName(const std::filesystem::path& path);

// Whether training can go on from the file: .macula holds all that this takes, others the splats alone.
bool holdsTraining(const std::filesystem::path& path);

// Writes the format of the name's ending; `displayColours` writes colours as they are displayed, for programs
// that know no linear light, and is not for what holds a training. Returns how many splats had numbers that
// the format cannot hold, and were limited.
Result<std::size_t> writeTrained(const std::filesystem::path& path, const splat::TrainingState& state,
                                 bool displayColours);

// The splats alone, likewise; usage for what holds a training.
Result<std::size_t> writeSplats(const std::filesystem::path& path, const splat::Splats& splats,
                                bool displayColours);

}  // namespace macula::app
