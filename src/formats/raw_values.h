// The voxels of a NIfTI, NRRD or MetaImage file.
#pragma once

#include <filesystem>

#include "formats/raw_image.h"

namespace macula::formats {

struct ValuesInFile {
    std::filesystem::path file;
    std::uint64_t offset = 0;  // of the values, or of the compressed stream that holds them
    std::uint64_t skip = 0;    // of what is in that stream
    bool compressed = false;   // zlib or gzip
    bool bigEndian = false;
};

// The same for the volume of that number, from 1, of several.
ValuesInFile valuesOfVolume(ValuesInFile values, const RawImageLayout& layout, std::size_t volume);

// As checkLayout, for the size of that file.
Result<void> checkExtent(const RawImageLayout& layout, const ValuesInFile& values);

// Fails with inputNotUsable when the file is too short, or its compressed stream or the checksum of that is
// wrong. Memory grows with what is read, not with what was announced.
Result<RawImage> readValues(RawImageLayout layout, const ValuesInFile& values, Progress& progress);

}  // namespace macula::formats
