// Writes NRRD and MetaImage files with ITK; text_header.h reads them.
#pragma once

#include <filesystem>

#include "formats/raw_image.h"

namespace macula::formats {

// .nrrd and .mha are one file; .nhdr and .mhd put the values into NAME.raw next to them.
Result<void> writeNrrd(const std::filesystem::path& path, const RawImage& image);
Result<void> writeMetaImage(const std::filesystem::path& path, const RawImage& image);

}  // namespace macula::formats
