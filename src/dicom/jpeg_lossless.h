// Lossless JPEG with first-order prediction (ISO 10918-1 annex H, selection value 1), which is what archives
// compress CT with: several times as fast as the general decoder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace macula::dicom {

enum class JpegLosslessResult {
    decoded,
    damaged,
    otherKind,  // another process, predictor, or with restarts: for the general decoder
};

// One frame of one component into `cells` (columns * rows). Reads nothing outside of `stream`, whatever it
// holds.
JpegLosslessResult decodeJpegLossless(std::span<const std::byte> stream, int columns, int rows,
                                      std::span<std::uint16_t> cells);

}  // namespace macula::dicom
