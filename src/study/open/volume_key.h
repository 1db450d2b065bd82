// Identifies a volume within its series by attributes of its images. Other files in the folder, of another
// phase or no volume, do not change the key; they may change the place of the volume in the list.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "study/open/found_volumes.h"

namespace macula::study {

// For each: a digest of modality, frame of reference, orientation, and all attributes that split a series
// (rules/split.json: times, phases, echoes, kernels) and that all images of the volume share. Of volumes of
// one series with equal digests, the second gets "-2", and so on. Reads each image once; FoundVolumes::key()
// keeps the result.
std::vector<std::string> volumeKeys(std::span<const FoundVolume> volumes);

}  // namespace macula::study
