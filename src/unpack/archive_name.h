// Which files are opened as folders.
#pragma once

#include <filesystem>

namespace macula::unpack {

// Whether the file is a ZIP, tar (compressed by gzip, xz, bzip2 or Zstandard, or not) or ISO 9660 file by its
// content, or is at least named like an archive, so that a person expects one: then unpack() says what is
// wrong with it. False for DICOM files (PS3.10 7.1), whatever they are called, and for what is no regular
// file.
bool isArchive(const std::filesystem::path& file);

}  // namespace macula::unpack
