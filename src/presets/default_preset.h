// What a volume is shown with when nobody chose.
#pragma once

#include <string>

#include "base/volume.h"

namespace macula::presets {

// The name of one of transferFiles(). CT: "cinematic-chest" when there is a lung's worth of lung in it, else
// "cinematic-bone", which needs no contrast agent. PET and other emission: "cinematic-pet"; all else:
// "cinematic-mr". These two adapt to any range of values. Where that would show nothing (SeenValues), the
// first of the built-in presets for such images that shows something, if there is one. The volume must be
// stored16.
std::string defaultTransfer(const Volume& volume);

}  // namespace macula::presets
