// Volumes in the files of research programs: NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr) and MetaImage (.mha,
// .mhd); the extension selects the format. Suppresses exceptions and output of the libraries.
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
#include "formats/volume_axis.h"

namespace macula::formats {

// ".nii.gz, .nii, ...": all extensions for writing. Headers of pairs (.hdr) can only be read.
std::string volumeFileEndings();

// Decides by the extension, in upper or lower case.
bool isVolumeFileName(const std::filesystem::path& path);

// The files that writing `path` makes: itself, and for .nhdr and .mhd the file with the values. That has the
// name of the header, with _ for a percent sign or control character, because other programs read a percent
// sign as a pattern. usage for other extensions.
Result<std::vector<std::filesystem::path>> filesOfVolumeFile(const std::filesystem::path& path);

// The separate file with the values of a header; nothing without one, or when it cannot be read.
std::optional<std::filesystem::path> valuesFileOf(const std::filesystem::path& path);

// Writes values in units (HU for CT) as int16, uint16 or float32, the first that holds all of them exactly,
// those of padding too (see Volume::value). Keeps worldFromVoxel, sheared or not. The file names no patient.
// Writes it whole or not at all, and replaces an existing one.
Result<void> writeVolumeFile(const Volume& volume, const std::filesystem::path& path, Progress& progress);

// Writes the numbers of the segments as int16 where they fit, otherwise uint16, without their names.
Result<void> writeVolumeFile(const LabelMap& map, const std::filesystem::path& path, Progress& progress);

struct VolumeFileInfo {
    std::string format;  // "NIfTI"
    std::string values;  // "int16"
    glm::ivec3 size{0};
    glm::dmat4 worldFromVoxel{1.0};
    std::vector<Text> assumptions;
    bool isCalibrated = true;  // as in Provenance
    std::size_t volumes = 1;   // one for each point in time, or of another axis
    VolumeAxis axis = {};      // of these
};

// Reads only the header.
Result<VolumeFileInfo> readVolumeFileInfo(const std::filesystem::path& path);

// 16-bit storage when that is exact, otherwise float32. `number`, from 1, chooses one of several volumes, one
// for each point in time; that, a missing orientation and the unit are among the assumptions. inputNotUsable
// for a damaged file, or one without a volume of scalars; usage when there is no volume `number`. The size of
// the file limits memory.
Result<std::shared_ptr<const Volume>> readVolumeFile(const std::filesystem::path& path, Progress& progress,
                                                     std::size_t number = 1);

}  // namespace macula::formats
