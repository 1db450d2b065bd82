// Volumes in the files of research programs: NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr) and MetaImage (.mha,
// .mhd). The ending of the name says which. Exceptions and output of the libraries stop here.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/label_map.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::formats {

// ".nii.gz, .nii, ...": all that are known.
std::string volumeFileEndings();

// By the ending of the name, in any case of letters.
bool isVolumeFileName(const std::filesystem::path& path);

// The files that writing `path` makes: itself, and for .nhdr and .mhd the one with the values. Fails with
// usage when the ending is unknown.
Result<std::vector<std::filesystem::path>> filesOfVolumeFile(const std::filesystem::path& path);

// The file with the values, where `path` is a header that lies beside them; nothing when it cannot be read.
std::optional<std::filesystem::path> valuesFileOf(const std::filesystem::path& path);

// Values in units (HU for CT), as int16, uint16 or float32, the first that holds all of them exactly; those
// of padding too (see Volume::value). Orientation is that of worldFromVoxel, sheared or not. Nothing in the
// file names a patient. Written whole or not at all; replaces what is there.
Result<void> writeVolumeFile(const Volume& volume, const std::filesystem::path& path, Progress& progress);

// The numbers of the segments, as int16 where they fit, else uint16. Their names are not written.
Result<void> writeVolumeFile(const LabelMap& map, const std::filesystem::path& path, Progress& progress);

struct VolumeFileInfo {
    std::string format;  // "NIfTI"
    std::string values;  // "int16"
    glm::ivec3 size{0};
    glm::dmat4 worldFromVoxel{1.0};
    std::vector<std::string> assumptions;
    bool isCalibrated = true;  // as in Provenance
};

// From the header alone.
Result<VolumeFileInfo> readVolumeFileInfo(const std::filesystem::path& path);

// 16-bit storage when that is exact, else float32. Fails with inputNotUsable for what is no volume of
// scalars or is damaged; memory is bounded by what the file can hold. Missing orientation and unit are among
// the assumptions.
Result<std::shared_ptr<const Volume>> readVolumeFile(const std::filesystem::path& path, Progress& progress);

}  // namespace macula::formats
