// Ends the writing of a DICOM object. Only for the writers of this folder.
#pragma once

#include <filesystem>
#include <string_view>

#include "base/result.h"

class DcmFileFormat;  // of DCMTK
class DcmDataset;

namespace macula::dicom {

// Explicit VR little endian, whole or not at all, in place of a file that is there. Fails with
// outputNotWritable.
Result<void> saveObject(const std::filesystem::path& path, DcmFileFormat& format);

// Whether a text needs another character set than the default one (PS3.5 6.1.2).
bool isAscii(std::string_view text);

// Rewrites texts and names of the data set, not those of items, in UTF-8, and says so. Returns whether it
// succeeded.
bool convertToUtf8(DcmDataset& dataset);

}  // namespace macula::dicom
