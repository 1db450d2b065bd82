// What a volume is shown with when nobody chose.
#pragma once

#include <string>

#include "base/volume.h"

namespace macula::presets {

// The name of one of transferFiles(). Body Part Examined decides where the voxels bear it out (head, teeth
// and limbs without lungs, contrast agent in heart, vessels and abdomen); it is often wrong. Else CT:
// "cinematic-chest" when there is a lung's worth of lung in it, or "cinematic-bone", which needs no contrast
// agent; CT that has no Hounsfield units: "cinematic-micro-ct". PET and other emission: "cinematic-pet"; all
// else: "cinematic-mr". These three adapt to any range of values. Where a choice would show nothing
// (SeenValues), that of the kind of images, then the first of the built-in presets for such images that shows
// something, if there is one. The volume must be stored16.
std::string defaultTransfer(const Volume& volume);

}  // namespace macula::presets
