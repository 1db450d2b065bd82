// The dose in a region that is a set of voxels.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "base/progress.h"
#include "base/result.h"
#include "base/voxel_set.h"
#include "study/dose/dose_field.h"
#include "study/dose/dose_histogram.h"

namespace macula::study {

struct RegionDose {
    std::size_t voxels = 0;         // of the region
    glm::ivec3 samplesPerVoxel{1};  // along each axis of the voxels
    std::size_t samples = 0;
    std::size_t outside = 0;  // of them: where there is no dose, for instance outside its grid
    DoseHistogram histogram;  // of the others

    double outsideShare() const { return samples > 0 ? double(outside) / double(samples) : 0.0; }
};

// Takes the dose at the centre of each voxel. Where voxels are larger than those of the dose, or fewer than a
// hundred, it divides each into equal parts and takes the dose at the centre of each part. Fails with
// cancelled or outOfMemory.
Result<RegionDose> doseIn(const VoxelSet& region, const glm::dmat4& worldFromVoxel, const DoseField& dose,
                          Progress& progress);

}  // namespace macula::study
