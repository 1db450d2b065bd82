// The voxels of each number in a map of numbers: a label map as programs write it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "base/voxel_set.h"

namespace macula {

// By number; 0 is none of them. Padding counts with its value. Errors: inputNotUsable for values that are no
// whole numbers from 0 to 65535, such as fractions, negative ones and NaN, and for more than `most` numbers;
// outOfMemory; cancelled. Throws nothing.
Result<std::map<std::uint16_t, VoxelSet>> labelSets(const Volume& labels, std::size_t most,
                                                    const CancelToken& token = {});

}  // namespace macula
