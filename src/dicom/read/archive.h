// Archives, which hold images and are not opened.
#pragma once

#include <filesystem>
#include <string_view>

namespace macula::dicom {

// "zip", "gzip", "bzip2", "xz", "Zstandard", "tar", "7z" or "RAR", for a person; empty for any other file. By
// what the file begins with; and by its name in so far as a name that is one of another kind of file wins:
// programs and documents on discs are zips as well, and volumes in NIfTI are packed by gzip.
std::string_view archiveKind(const std::filesystem::path& file);

}  // namespace macula::dicom
