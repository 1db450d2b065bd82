// Which of the volumes of its series a volume is, by what its images say of themselves: another file in the
// folder, of another phase or of no volume at all, changes nothing of that. Its place in the list may change.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "study/open/found_volumes.h"

namespace macula::app {

// Of each: a digest of the frame of reference, the orientation, and all attributes that tell images of a
// series apart (rules/split.json: times, phases, echoes, kernels) and that are the same in all of the
// volume's images. Where several volumes of the series have all of that in common, those after the first of
// them have a number too. Looks at each image once: FoundVolumes::key() has them at hand.
std::vector<std::string> volumeKeys(std::span<const FoundVolume> volumes);

}  // namespace macula::app
