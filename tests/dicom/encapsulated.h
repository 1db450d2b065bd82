// Files with encapsulated pixel data, cut into fragments as the test likes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dicom/pixels/pixels.h"

namespace macula::dicom::test {

inline constexpr const char* kRle = "1.2.840.10008.1.2.5";
inline constexpr const char* kJpegBaseline = "1.2.840.10008.1.2.4.50";
inline constexpr const char* kJpegExtended = "1.2.840.10008.1.2.4.51";
inline constexpr const char* kJpegLossless = "1.2.840.10008.1.2.4.57";
inline constexpr const char* kJpegLosslessFirstOrder = "1.2.840.10008.1.2.4.70";
inline constexpr const char* kJpegLs = "1.2.840.10008.1.2.4.80";
inline constexpr const char* kJpeg2000 = "1.2.840.10008.1.2.4.90";

// The code stream of one frame, by DCMTK (JPEG 2000 by OpenJPEG).
std::string encode(const char* transferSyntaxUid, int columns, int rows, int bits,
                   const std::vector<std::uint16_t>& cells);

// JPEG 2000 in square tiles; 0 for one tile.
std::string encodeJpeg2000(int columns, int rows, int bits, const std::vector<std::uint16_t>& cells,
                           int tileSize = 0);

// Rows, Columns, NumberOfFrames and the bits, explicit little endian; without pixel data.
std::string imageHeader(const PixelLayout& layout);

// Streams to fragments, of even length, and the offset of each stream's first one.
struct Fragments {
    std::vector<std::string> fragments;
    std::vector<std::uint64_t> offsets;
};
Fragments cut(const std::vector<std::string>& streams, std::size_t fragmentsEach);

// Items, and the delimiter.
std::string encapsulated(const std::vector<std::string>& fragments, const std::string& offsetTable = {});
std::string basicOffsets(const Fragments& fragments);

}  // namespace macula::dicom::test
