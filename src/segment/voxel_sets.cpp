#include "segment/voxel_sets.h"

#include <cmath>

#include "base/available_memory.h"

namespace macula::segment {

VoxelSet united(const VoxelSet& a, const VoxelSet& b) {
    if (a.isEmpty()) return b.cropped();
    if (b.isEmpty()) return a.cropped();
    VoxelSet both(glm::min(a.low(), b.low()), glm::max(a.high(), b.high()));
    a.forEach([&](const glm::ivec3& voxel) { both.add(voxel); });
    b.forEach([&](const glm::ivec3& voxel) { both.add(voxel); });
    return both.cropped();
}

VoxelSet without(const VoxelSet& a, const VoxelSet& b) {
    if (a.isEmpty()) return {};
    VoxelSet rest(a.low(), a.high());
    a.forEach([&](const glm::ivec3& voxel) {
        if (!b.contains(voxel)) rest.add(voxel);
    });
    return rest.cropped();
}

VoxelSet intersected(const VoxelSet& a, const VoxelSet& b) {
    if (a.isEmpty() || b.isEmpty()) return {};
    VoxelSet common(a.low(), a.high());
    a.forEach([&](const glm::ivec3& voxel) {
        if (b.contains(voxel)) common.add(voxel);
    });
    return common.cropped();
}

VoxelSet complement(const VoxelSet& set, const glm::ivec3& low, const glm::ivec3& high) {
    VoxelSet rest(low, high);
    for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i)
                if (!set.contains({i, j, k})) rest.add({i, j, k});
    return rest;
}

double voxelMl(const glm::dmat4& worldFromVoxel) {
    constexpr double kMm3PerMl = 1000.0;
    return std::abs(glm::determinant(glm::dmat3(worldFromVoxel))) / kMm3PerMl;
}

Result<void> checkMemory(double voxels, double bytesPerVoxel) {
    const double bytes = voxels * bytesPerVoxel;
    const auto available = availableMemory();
    constexpr double kMost = 1e15;
    if (bytes < kMost && (!available || bytes <= double(*available))) return {};
    return notEnoughMemory(static_cast<std::uint64_t>(std::min(bytes, kMost)), available);
}

Error segmentingCancelled() {
    return {ErrorCode::cancelled, Text("Segmenting was cancelled."), {}, {}};
}

}  // namespace macula::segment
