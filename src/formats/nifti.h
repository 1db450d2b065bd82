// NIfTI files: .nii and .nii.gz, and pairs of .hdr and .img; versions 1 and 2 are read, and 1 is written.
//
// Not by ITK: its NIfTI reader and writer (5.2.1) make every affine orthonormal in silence, so a series of a
// tilted gantry would change its shape on the way. Header and quaternions are niftilib's; its readers, which
// trust what the header says of sizes and open a second file that it names, are not used.
#pragma once

#include <filesystem>
#include <optional>

#include "formats/raw_image.h"

namespace macula::formats {

// The affine goes into the sform, and into the qform too when that can hold it, which a shear it cannot. No
// name, date or description is written.
Result<void> writeNifti(const std::filesystem::path& path, const RawImage& image, Progress& progress);

// The file with the values, where `path` is the header of a pair; nothing for any other file.
std::optional<std::filesystem::path> niftiValuesFile(const std::filesystem::path& path);

// Of the header alone: its claims are checked against the size of the file.
Result<RawImageLayout> readNiftiLayout(const std::filesystem::path& path);
// The sform is taken, else the qform, else the spacing alone, and that is said.
// Of several volumes, one for each point in time, the one of that number, from 1.
Result<RawImage> readNifti(const std::filesystem::path& path, Progress& progress, std::size_t volume = 1);

}  // namespace macula::formats
