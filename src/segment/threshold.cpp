#include "segment/threshold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "segment/voxel_sets.h"

namespace macula::segment {

namespace {

Error usage(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

Error noMemory() {
    return {ErrorCode::outOfMemory,
            Text("There is not enough memory to segment this volume."),
            {},
            Text("Close other programs, or segment within a smaller region.")};
}

bool isIn(const Volume& volume, const ValueRange& range, const glm::ivec3& v) {
    if (volume.isPadding(v.x, v.y, v.z)) return false;
    const double value = volume.value(v.x, v.y, v.z);
    return value >= range.low && value <= range.high;  // false for NaN
}

bool isInGrid(const glm::ivec3& v, const glm::ivec3& size) {
    return v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < size.x && v.y < size.y && v.z < size.z;
}

// Nothing where all of them are padding.
std::optional<double> meanAround(const Volume& volume, const glm::ivec3& seed) {
    double sum = 0.0;
    int count = 0;
    for (int k = -1; k <= 1; ++k)
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                const glm::ivec3 v = seed + glm::ivec3(i, j, k);
                if (!isInGrid(v, volume.size()) || volume.isPadding(v.x, v.y, v.z)) continue;
                const double value = volume.value(v.x, v.y, v.z);
                if (!std::isfinite(value)) continue;
                sum += value;
                ++count;
            }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::vector<glm::ivec3> neighbours(bool corners) {
    std::vector<glm::ivec3> all;
    for (int k = -1; k <= 1; ++k)
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                const int steps = std::abs(i) + std::abs(j) + std::abs(k);
                if (steps == 1 || (corners && steps > 1)) all.emplace_back(i, j, k);
            }
    return all;
}

Result<ValueRange> rangeFor(const Volume& volume, const GrowRequest& request) {
    if (!isInGrid(request.seed, volume.size()))
        return usage(Text("The point lies outside of the volume."), Text("Choose a point within it."));
    if (request.within != nullptr && !request.within->contains(request.seed))
        return usage(Text("The point lies outside of the region to grow in."),
                     Text("Choose a point within it, or grow in the whole volume."));
    if (!(request.tolerance >= 0.0) || !std::isfinite(request.tolerance))
        return usage(Text("The tolerance is not a number from 0."),
                     Text("Enter one in the unit of the volume."));
    const auto mean = meanAround(volume, request.seed);
    const glm::ivec3& s = request.seed;
    if (!mean || volume.isPadding(s.x, s.y, s.z))
        return usage(Text("Nothing was measured at that point."), Text("Choose a point within the patient."));
    const ValueRange range{*mean - request.tolerance, *mean + request.tolerance};
    if (!isIn(volume, range, s))
        return usage(Text("The point differs from its surroundings by more than the tolerance."),
                     Text("Raise the tolerance, or choose a point away from an edge."));
    return range;
}

}  // namespace

Result<VoxelSet> voxelsBetween(const Volume& volume, const ValueRange& range, const VoxelSet* within,
                               Progress& progress) try {
    if (!std::isfinite(range.low) || !std::isfinite(range.high) || range.low > range.high)
        return usage(Text("The lower threshold is above the upper one, or one of them is no number."),
                     Text("Enter two values in the unit of the volume, the lower one first."));
    if (within != nullptr && within->isEmpty()) return VoxelSet();
    const glm::ivec3 low = within != nullptr ? glm::max(within->low(), glm::ivec3(0)) : glm::ivec3(0);
    const glm::ivec3 high =
        within != nullptr ? glm::min(within->high(), volume.size() - 1) : volume.size() - 1;
    if (glm::any(glm::greaterThan(low, high))) return VoxelSet();
    MACULA_TRY_VOID(checkMemory(2.0 * VoxelSet::bytesFor(low, high), 1.0));
    VoxelSet set(low, high);
    const auto count = std::size_t(high.z) - std::size_t(low.z) + 1;
    progress.beginStage(Text("Looking for values"), count);
    parallelFor(
        count,
        [&](std::size_t slice) {
            const int k = low.z + int(slice);  // slices share no word of the set
            for (int j = low.y; j <= high.y; ++j)
                for (int i = low.x; i <= high.x; ++i)
                    if ((within == nullptr || within->contains({i, j, k})) && isIn(volume, range, {i, j, k}))
                        set.add({i, j, k});
            progress.advance();
        },
        progress.token());
    if (progress.cancelled()) return segmentingCancelled();
    return set.cropped();
} catch (const std::bad_alloc&) {
    return noMemory();
}

Result<Grown> grownFrom(const Volume& volume, const GrowRequest& request, Progress& progress) try {
    MACULA_TRY(const ValueRange range, rangeFor(volume, request));
    const glm::ivec3 size = volume.size();
    MACULA_TRY_VOID(checkMemory(2.0 * VoxelSet::bytesFor(glm::ivec3(0), size - 1), 1.0));
    progress.beginStage(Text("Growing a region"), 1);
    const std::vector<glm::ivec3> steps = neighbours(request.corners);
    Grown grown{.voxels = VoxelSet(glm::ivec3(0), size - 1), .range = range};
    std::size_t count = 1;
    grown.voxels.add(request.seed);
    // Breadth first: where a limit stops it, what is nearest to the seed is there.
    std::vector<glm::ivec3> front{request.seed};
    std::vector<glm::ivec3> next;
    while (!front.empty() && !grown.isCutShort) {
        if (progress.cancelled()) return segmentingCancelled();
        next.clear();
        for (const glm::ivec3& at : front) {
            for (const glm::ivec3& step : steps) {
                const glm::ivec3 v = at + step;
                if (!isInGrid(v, size) || grown.voxels.contains(v)) continue;
                if ((request.within != nullptr && !request.within->contains(v)) || !isIn(volume, range, v))
                    continue;
                if (request.mostVoxels > 0 && count >= request.mostVoxels) {
                    grown.isCutShort = true;
                    break;
                }
                grown.voxels.add(v);
                ++count;
                next.push_back(v);
            }
            if (grown.isCutShort) break;
        }
        std::swap(front, next);
    }
    grown.voxels = grown.voxels.cropped();
    progress.advance();
    return grown;
} catch (const std::bad_alloc&) {
    return noMemory();
}

}  // namespace macula::segment
