// A volume whose picture says if it is mirrored: water, and a block of 1000 HU at the patient's right,
// anterior and superior. Voxels of 1 x 1 x 2 mm; the middle one, (20, 15, 10), lies at the origin.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "base/volume.h"

namespace macula::viewer::test {

inline constexpr glm::ivec3 kSliceVolumeSize{41, 31, 21};
inline constexpr glm::dvec3 kBlockCentreMm{-13.0, -9.0, 12.0};

inline VolumeOptions sliceVolumeOptions() {
    return {.size = kSliceVolumeSize,
            .worldFromVoxel = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {-20, -15, -20}),
            .unitsFromStored = {.slope = 1.0, .intercept = -1000.0},
            .unit = Unit::hounsfield,
            .modality = "CT",
            .windows = {{.center = 500.0, .width = 1000.0, .explanation = {}, .function = {}}}};
}

inline std::shared_ptr<const Volume> sliceVolume(VolumeOptions options = sliceVolumeOptions()) {
    const glm::ivec3 size = kSliceVolumeSize;
    std::vector<std::uint16_t> voxels;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const glm::ivec3 away = glm::abs(glm::ivec3(i, j, k) - glm::ivec3(7, 6, 16));
                voxels.push_back(away.x <= 3 && away.y <= 3 && away.z <= 2 ? 2000 : 1000);
            }
    auto volume = Volume::create(std::move(options), std::move(voxels));
    return std::make_shared<const Volume>(*std::move(volume));
}

}  // namespace macula::viewer::test
