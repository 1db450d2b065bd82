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

// ".nii.gz, .nii, ...": all that are written. Headers of pairs (.hdr) are read as well.
std::string volumeFileEndings();

// By the ending of the name, in any case of letters.
bool isVolumeFileName(const std::filesystem::path& path);

// The files that writing `path` makes: itself, and for .nhdr and .mhd the one with the values. Fails with
// usage when the ending is unknown. The values have the name of the header, with _ for a percent sign, which
// other programs take for a pattern.
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
    std::size_t volumes = 1;   // one for each point in time
};

// From the header alone.
Result<VolumeFileInfo> readVolumeFileInfo(const std::filesystem::path& path);

// 16-bit storage when that is exact, else float32. Fails with inputNotUsable for what is no volume of
// scalars or is damaged; memory is bounded by what the file can hold. Missing orientation and unit are among
// the assumptions. Of a file with several volumes, one for each point in time, the one of that number, from
// 1, is read, and that too is among them; fails with usage when there is none.
Result<std::shared_ptr<const Volume>> readVolumeFile(const std::filesystem::path& path, Progress& progress,
                                                     std::size_t number = 1);

}  // namespace macula::formats
