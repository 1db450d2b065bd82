// The preset for a volume when nobody has chosen one.
#pragma once

#include <string>

#include "base/volume.h"

namespace macula::presets {

// The name of one of transferFiles(). Body Part Examined, which is often wrong, decides only if the voxels
// confirm it (head, teeth and limbs without lungs, contrast agent in heart, vessels and abdomen). Otherwise
// CT: "cinematic-chest" if it shows at least a lung, or "cinematic-bone", which needs no contrast agent; CT
// without Hounsfield units: "cinematic-micro-ct". PET and other emission: "cinematic-pet"; all others:
// "cinematic-mr". The last three adapt to any range of values. If a choice would show nothing (SeenValues),
// the choice for the kind of images; then the first built-in preset for such images that shows something, if
// there is one. The volume must be stored16.
std::string defaultTransfer(const Volume& volume);

}  // namespace macula::presets
