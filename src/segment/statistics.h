// What the values of a segment are.
#pragma once

#include <cstddef>
#include <optional>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "base/voxel_set.h"

namespace macula::segment {

struct Statistics {
    std::size_t voxels = 0;
    double ml = 0.0;             // all voxels, those without a value too
    std::size_t unmeasured = 0;  // voxels of padding, or without a number
    // Of the other voxels, in the unit of the volume; nothing where there is none.
    struct Values {
        double mean = 0.0;
        double deviation = 0.0;  // of all of them (divided by their number)
        double least = 0.0;
        double most = 0.0;
    };
    std::optional<Values> values = {};
};

// Voxels beyond the volume are not counted. Error: cancelled.
Result<Statistics> statisticsOf(const VoxelSet& set, const Volume& volume, Progress& progress);

}  // namespace macula::segment
