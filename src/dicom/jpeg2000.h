// JPEG 2000, which DCMTK lacks, by GDCM.
#pragma once

#include <cstddef>
#include <span>

#include "base/result.h"
#include "dicom/intensity.h"

namespace macula::dicom {

// Decodes one grayscale frame into exactly rows * columns cells. Fails with inputNotUsable when the code
// stream is broken or is of another size. Thread-safe.
Result<void> decodeJpeg2000(std::span<const std::byte> codeStream, int columns, int rows,
                            const CellFormat& format, std::span<std::uint16_t> cells);

}  // namespace macula::dicom
