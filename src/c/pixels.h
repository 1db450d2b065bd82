// The memory of a host that pixels are written to.
#pragma once

#include <cstdint>

#include "base/result.h"

namespace macula::c {

// usage for a size that no picture has.
Result<void> checkSize(std::int32_t width, std::int32_t height);

struct Pixels {
    std::uint8_t* rgba = nullptr;
    std::uint64_t bytes = 0;
    std::uint64_t rowBytes = 0;  // 0: 4 * width
};

// The bytes from row to row, for a size that checkSize accepts; usage if the memory is too small.
Result<std::uint64_t> rowBytesOf(const Pixels& pixels, std::int32_t width, std::int32_t height);

}  // namespace macula::c
