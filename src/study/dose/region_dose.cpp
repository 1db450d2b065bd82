#include "study/dose/region_dose.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>
#include <vector>

#include "base/available_memory.h"
#include "base/exceptions.h"

namespace macula::study {

namespace {

constexpr std::size_t kFewVoxels = 100;
constexpr std::size_t kEnoughSamples = 2000;
constexpr int kMostPerAxis = 8;
constexpr double kMostSamples = 1.2e7;  // of a region that is divided

// How many voxels of the dose a step from voxel to voxel crosses, rounded up, for each axis.
glm::ivec3 stepsPerVoxel(const glm::dmat4& worldFromVoxel, const Volume& dose) {
    const glm::dmat3 doseFromVoxel =
        glm::inverse(glm::dmat3(dose.worldFromVoxel())) * glm::dmat3(worldFromVoxel);
    constexpr double kSameSize = 1e-3;
    glm::ivec3 steps(1);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 crossed = glm::abs(doseFromVoxel[axis]);
        for (int of = 0; of < 3; ++of)
            if (dose.size()[of] == 1) crossed[of] = 0.0;
        const double most = std::max({crossed.x, crossed.y, crossed.z});
        steps[axis] = std::clamp(int(std::ceil(most - kSameSize)), 1, kMostPerAxis);
    }
    return steps;
}

glm::ivec3 partsOf(std::size_t voxels, const glm::dmat4& worldFromVoxel, const Volume& dose) {
    glm::ivec3 parts = stepsPerVoxel(worldFromVoxel, dose);
    const auto samples = [&] { return double(voxels) * parts.x * parts.y * parts.z; };
    if (samples() > kMostSamples) return glm::ivec3(1);
    if (voxels >= kFewVoxels) return parts;
    while (samples() < double(kEnoughSamples) && parts != glm::ivec3(kMostPerAxis))
        parts = glm::min(parts + 1, glm::ivec3(kMostPerAxis));
    return parts;
}

}  // namespace

Result<RegionDose> doseIn(const VoxelSet& region, const glm::dmat4& worldFromVoxel, const DoseField& dose,
                          Progress& progress) try {
    RegionDose made;
    made.voxels = region.count();
    made.samplesPerVoxel = partsOf(made.voxels, worldFromVoxel, dose.volume());
    const glm::ivec3 parts = made.samplesPerVoxel;
    made.samples = made.voxels * std::size_t(parts.x * parts.y * parts.z);
    const double bytes = double(made.samples) * double(sizeof(float));
    const auto available = availableMemory();
    if (available && bytes > double(*available))
        return notEnoughMemory(static_cast<std::uint64_t>(bytes), *available);
    std::vector<float> samples;
    samples.reserve(made.samples);
    int slice = region.low().z - 1;
    bool isCancelled = false;
    region.forEach([&](const glm::ivec3& voxel) {
        if (voxel.z != slice) {
            slice = voxel.z;
            isCancelled = progress.cancelled();
        }
        if (isCancelled) return;
        for (int k = 0; k < parts.z; ++k) {
            for (int j = 0; j < parts.y; ++j) {
                for (int i = 0; i < parts.x; ++i) {
                    const glm::dvec3 part = (glm::dvec3(i, j, k) + 0.5) / glm::dvec3(parts) - 0.5;
                    const glm::dvec3 mm(worldFromVoxel * glm::dvec4(glm::dvec3(voxel) + part, 1.0));
                    if (const auto there = dose.at(mm)) samples.push_back(float(*there));
                }
            }
        }
    });
    if (isCancelled)
        return Error{ErrorCode::cancelled, Text("Computing the dose in regions was cancelled."), {}, {}};
    made.outside = made.samples - samples.size();
    made.histogram = DoseHistogram(std::move(samples));
    return made;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("compute the dose in a region"));
}

}  // namespace macula::study
