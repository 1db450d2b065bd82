// JPEG 2000, which DCMTK lacks. Calls OpenJPEG directly, because GDCM's wrapper aborts on broken streams and
// prints to the terminal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/result.h"

namespace macula::dicom {

// Decodes one grayscale frame of up to 16 bits into exactly rows * columns cells. Fails with inputNotUsable
// when the code stream is broken, lacks a tile, is in colour or of another size. Thread-safe.
Result<void> decodeJpeg2000(std::span<const std::byte> codeStream, int columns, int rows,
                            std::span<std::uint16_t> cells);

}  // namespace macula::dicom
