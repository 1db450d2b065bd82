// RLE Lossless (PS3.5 annex G). Not by DCMTK, whose decoder reads wherever the RLE header points.
#pragma once

#include <cstddef>
#include <span>

namespace macula::dicom {

// Decodes one frame of one sample per pixel, into little-endian cells of `bytesPerCell` bytes that fill
// `cells`. A frame with one segment only fills the lowest byte of each cell. False when the frame is damaged,
// or too short.
bool decodeRle(std::span<const std::byte> frame, std::size_t bytesPerCell, std::span<std::byte> cells);

}  // namespace macula::dicom
