// Training key (splat::TrainerOptions::key): identifies what a training learns, so that it resumes with
// nothing else.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/trace/environment.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::live {

// One line each for study, preset, clip and lights, and for additions if there are any: the word and a
// SHA-256 of the content, not of names. No patient data. `volume` is the stored16 one that is drawn.
std::string trainingIdentity(const Volume& volume, const TransferFunction& function, const Clip& clip,
                             const trace::Environment& lights, const Additions& additions = {});

// Fails with inputNotUsable, naming the differences, if the training `saved` in `file` may not resume with
// pictures of `now`.
Result<void> checkTrainingIdentity(const std::string& saved, const std::string& now,
                                   const std::filesystem::path& file);

}  // namespace macula::live
