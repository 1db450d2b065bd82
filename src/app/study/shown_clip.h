// What is shown of a study: the clip that was chosen, and without the table where that was asked for.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip_json.h"

namespace macula::app {

struct ShownClip {
    Clip clip;
    bool tableRemoved = false;       // asked for, and something was: where it was not sure, nothing went
    std::vector<std::string> notes;  // about the table
};

Result<ShownClip> shownClip(const ClipPreset& preset, bool removeTable, const Volume& volume,
                            Progress& progress);

}  // namespace macula::app
