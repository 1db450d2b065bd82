// What a saved training is of, so that it is not gone on with on something else (splat::TrainerOptions::key).
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/trace/environment.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::app {

// A line each, of study, preset, clip, lights, and additions where there are any: the word and a SHA-256 over
// what they are, not over what they are called. No patient data. The volume as it is drawn, stored16.
std::string trainingKey(const Volume& volume, const TransferFunction& function, const Clip& clip,
                        const trace::Environment& lights, const Additions& additions = {});

// Fails with inputNotUsable, and says what is not the same, when training `saved` in `file` may not go on
// with pictures of `now`.
Result<void> checkTrainingKey(const std::string& saved, const std::string& now,
                              const std::filesystem::path& file);

}  // namespace macula::app
