#include "segment/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "segment/voxel_sets.h"

namespace macula::segment {

Result<Statistics> statisticsOf(const VoxelSet& set, const Volume& volume, Progress& progress) {
    progress.beginStage(Text("Reading the values of the segment"), 1);
    Statistics found;
    double mean = 0.0;
    double squares = 0.0;  // of the differences from the mean: the method of Welford
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    std::size_t count = 0;
    const glm::ivec3 size = volume.size();
    bool isCancelled = false;
    int slice = -1;
    set.forEach([&](const glm::ivec3& v) {
        if (v.z != slice) isCancelled = isCancelled || progress.cancelled();
        slice = v.z;
        const bool isHere = v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < size.x && v.y < size.y && v.z < size.z;
        if (isCancelled || !isHere) return;
        ++found.voxels;
        const double value = volume.value(v.x, v.y, v.z);
        if (volume.isPadding(v.x, v.y, v.z) || !std::isfinite(value)) {
            ++found.unmeasured;
            return;
        }
        ++count;
        const double off = value - mean;
        mean += off / double(count);
        squares += off * (value - mean);
        least = std::min(least, value);
        most = std::max(most, value);
    });
    if (isCancelled) return segmentingCancelled();
    found.ml = double(found.voxels) * voxelMl(volume.worldFromVoxel());
    if (count > 0)
        found.values =
            Statistics::Values{mean, std::sqrt(std::max(squares, 0.0) / double(count)), least, most};
    progress.advance();
    return found;
}

}  // namespace macula::segment
