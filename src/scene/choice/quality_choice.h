// Converts what the user typed after --quality to samples, bounces, filter and denoising.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/trace/quality.h"

namespace macula::scene {

// All built-in qualities, the fastest first.
Result<std::vector<trace::Quality>> builtInQualities();

// A built-in name, or a JSON file. usage when it is neither; inputNotUsable when the file is malformed.
Result<trace::Quality> chooseQuality(const std::string& nameOrFile);

}  // namespace macula::scene
