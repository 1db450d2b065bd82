// The voxels of a NIfTI, NRRD or MetaImage file.
#pragma once

#include <filesystem>

#include "formats/raw_image.h"

namespace macula::formats {

struct ValuesInFile {
    std::filesystem::path file;
    std::uint64_t offset = 0;  // where the values begin, or the compressed stream that holds them
    std::uint64_t skip = 0;    // bytes before the values in the uncompressed stream
    bool compressed = false;   // zlib or gzip
    bool bigEndian = false;
    // Values of this many volumes alternate, voxel by voxel, and those of number `part`, from 0, are wanted.
    std::size_t interleaved = 1;
    std::size_t part = 0;
};

// The error of a file that ends too early, or whose values are damaged.
Error cutOff();

// The place of one of several volumes, from 1.
ValuesInFile valuesOfVolume(ValuesInFile values, const RawImageLayout& layout, std::size_t volume);

// checkLayout with the size of that file, from `offset` on.
Result<void> checkExtent(const RawImageLayout& layout, const ValuesInFile& values);

// inputNotUsable when the file is too short, or its compressed stream or checksum is wrong. Memory grows with
// the data read, not with the size in the header.
Result<RawImage> readValues(RawImageLayout layout, const ValuesInFile& values, Progress& progress);

}  // namespace macula::formats
