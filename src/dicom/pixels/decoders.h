// Decoders of compressed pixels, a frame at a time, each with a source of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/result.h"

namespace macula::dicom {

// RLE Lossless (PS3.5 annex G). DCMTK's decoder is not used: it reads wherever the RLE header points. Decodes
// one frame of one sample per pixel, into little-endian cells of `bytesPerCell` bytes that fill `cells`. A
// frame with a single segment fills the lowest byte of each cell. Several samples per pixel make one cell,
// with the first sample in its highest bytes. False when the frame is damaged, or too short.
bool decodeRle(std::span<const std::byte> frame, std::size_t bytesPerCell, std::span<std::byte> cells);

// JPEG and JPEG-LS, by DCMTK. Decodes one frame of one component, of at most 16 bits, into `cells` (columns *
// rows). Fails with inputNotUsable when the stream is broken, or not what the header announced. Thread-safe.
// May throw std::bad_alloc.
Result<void> decodeJpeg(const std::string& transferSyntaxUid, std::span<const std::byte> stream, int columns,
                        int rows, std::span<std::uint16_t> cells);

// The same for three components, which come pixel by pixel in `samples` (3 * columns * rows). Returns their
// photometric interpretation: that of the header, or RGB where the decoder has converted them.
Result<std::string> decodeJpegColours(const std::string& transferSyntaxUid, std::span<const std::byte> stream,
                                      const std::string& photometricInterpretation, int columns, int rows,
                                      std::span<std::uint16_t> samples);

// JPEG 2000, which DCMTK lacks. Calls OpenJPEG directly, because GDCM's wrapper aborts on broken streams and
// prints to the terminal. Decodes one frame of up to 16 bits: of one component into rows * columns cells, of
// three, as RGB and pixel by pixel, into three times as many. Fails with inputNotUsable when the code stream
// is broken, lacks a tile, or is of another size. Thread-safe.
Result<void> decodeJpeg2000(std::span<const std::byte> codeStream, int columns, int rows,
                            std::span<std::uint16_t> cells);

}  // namespace macula::dicom
