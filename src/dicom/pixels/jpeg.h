// JPEG and JPEG-LS, by DCMTK.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/result.h"

namespace macula::dicom {

// Decodes one frame of one component, of at most 16 bits, into `cells` (columns * rows). Fails with
// inputNotUsable when the stream is broken, or not what the header announced. Thread-safe. May throw
// std::bad_alloc.
Result<void> decodeJpeg(const std::string& transferSyntaxUid, std::span<const std::byte> stream, int columns,
                        int rows, std::span<std::uint16_t> cells);

}  // namespace macula::dicom
