// Decodes the pixels of one file.
#pragma once

#include <cstdint>
#include <span>

#include "base/result.h"
#include "dicom/instance.h"

namespace macula::dicom {

// Reads the instance's only frame into `cells` (rows * columns; row by row), as the file has them: see
// unpackCells for what follows. 16-bit pixels go straight there, without another copy. Fails with
// inputNotUsable when the file is gone, changed since the scan, cut off, or in a transfer syntax this build
// cannot decode; `where` is then its path. Thread-safe.
Result<void> decodeCells(const Instance& instance, std::span<std::uint16_t> cells);

}  // namespace macula::dicom
