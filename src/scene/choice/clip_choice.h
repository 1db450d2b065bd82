// Converts what the user typed after --clip to a clip.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/volume/clip_json.h"

namespace macula::scene {

// All built-in clips, by name.
Result<std::vector<ClipPreset>> builtInClips();

// A built-in name or a JSON file; empty text keeps all of the volume. usage when it is neither;
// inputNotUsable when the file is malformed.
Result<ClipPreset> chooseClip(const std::string& nameOrFile);

// The name to show in a picture or a report, as publicPresetName; "none" without a clip.
std::string publicClipName(const std::string& nameOrFile);
std::string publicClipName(const ClipPreset& clip);

}  // namespace macula::scene
