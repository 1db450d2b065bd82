// What a volume is shown with when nobody chose.
#pragma once

#include <string>

#include "base/volume.h"

namespace macula::presets {

// The name of one of transferFiles(). CT: "cinematic-chest" when there is a lung's worth of lung in it, else
// "cinematic-bone", which needs no contrast agent. All else: "cinematic-mr", which adapts to any range of
// values.
std::string defaultTransfer(const Volume& volume);

}  // namespace macula::presets
