// RLE Lossless (PS3.5 annex G). DCMTK's decoder is not used: it reads wherever the RLE header points.
#pragma once

#include <cstddef>
#include <span>

namespace macula::dicom {

// Decodes one frame of one sample per pixel, into little-endian cells of `bytesPerCell` bytes that fill
// `cells`. A frame with a single segment fills the lowest byte of each cell. False when the frame is damaged,
// or too short.
bool decodeRle(std::span<const std::byte> frame, std::size_t bytesPerCell, std::span<std::byte> cells);

}  // namespace macula::dicom
