// NIfTI-1 files, .nii and .nii.gz.
//
// Not by ITK: its NIfTI reader and writer (5.2.1) make every affine orthonormal in silence, so a series of a
// tilted gantry would change its shape on the way. Header and quaternions are niftilib's; its readers, which
// trust what the header says of sizes and open a second file that it names, are not used.
#pragma once

#include <filesystem>

#include "formats/raw_image.h"

namespace macula::formats {

// The affine goes into the sform, and into the qform too when that can hold it, which a shear it cannot. No
// name, date or description is written.
Result<void> writeNifti(const std::filesystem::path& path, const RawImage& image, Progress& progress);

// Of the header alone: its claims are checked against the size of the file.
Result<RawImageLayout> readNiftiLayout(const std::filesystem::path& path);
// The sform is taken, else the qform, else the spacing alone, and that is said.
Result<RawImage> readNifti(const std::filesystem::path& path, Progress& progress);

}  // namespace macula::formats
