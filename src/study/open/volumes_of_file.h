// The volumes of one NIfTI or NRRD file with a fourth axis.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/glm.hpp>

#include "base/text.h"
#include "formats/volume_axis.h"

namespace macula::study {

inline constexpr std::size_t kMostVolumesOfFile = 10'000;  // more cannot be chosen from

struct VolumesOfFile {
    std::filesystem::path file;
    std::size_t count = 0;
    formats::VolumeAxis axis;
    glm::ivec3 size{0};  // of each
    glm::dmat4 worldFromVoxel{1.0};
};

// "time 2.5 s"; for a person. Says where the axis is no time, or the file does not say what it is.
Text labelOf(const VolumesOfFile& volumes, std::size_t volume);

}  // namespace macula::study
