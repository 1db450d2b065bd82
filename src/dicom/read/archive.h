// Recognises archives, which may hold images and are not opened.
#pragma once

#include <filesystem>
#include <string_view>

namespace macula::dicom {

// "zip", "gzip", "bzip2", "xz", "Zstandard", "tar", "7z" or "RAR", for a person; empty for any other file.
// The file's first bytes decide; but a name extension of another kind of file makes it empty: programs and
// documents on discs are zips as well, and NIfTI volumes are compressed by gzip.
std::string_view archiveKind(const std::filesystem::path& file);

}  // namespace macula::dicom
