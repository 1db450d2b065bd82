// NIfTI files: .nii and .nii.gz, and pairs of .hdr and .img. Reads versions 1 and 2, writes version 1.
//
// Does not use ITK: its NIfTI reader and writer (5.2.1) silently make every affine orthonormal, which would
// distort a series with a tilted gantry. Uses niftilib for header and quaternions, but not its readers, which
// trust the sizes in the header and open a second file that it names.
#pragma once

#include <filesystem>
#include <optional>

#include "formats/raw_image.h"

namespace macula::formats {

// Writes the affine as sform, and as qform if that can hold it: it cannot hold a shear. The only text written
// is valueNote(): no name, date or description.
Result<void> writeNifti(const std::filesystem::path& path, const RawImage& image, Progress& progress);

// The file with the values where `path` is the header of a pair; nothing for any other file.
std::optional<std::filesystem::path> niftiValuesFile(const std::filesystem::path& path);

// Reads only the header, and checks its claims against the size of the file.
Result<RawImageLayout> readNiftiLayout(const std::filesystem::path& path);
// Uses the sform, otherwise the qform, otherwise only the spacing, which is then among the assumptions.
// `volume`, from 1, chooses one of several volumes, one for each point in time.
Result<RawImage> readNifti(const std::filesystem::path& path, Progress& progress, std::size_t volume = 1);

}  // namespace macula::formats
