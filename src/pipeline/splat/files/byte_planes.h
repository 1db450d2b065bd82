// Numbers packed without loss: the first bytes of all, then the second bytes of all, and so on, by deflate.
//
// Bytes of the same rank are alike: signs and exponents of a picture's pixels are, their last digits are
// noise, and all are 0 where nothing is. deflate with only runs and Huffman codes (Z_RLE) finds as much in
// them as it would with matches, in a third of the time: pictures of 8 samples, 64 % empty, become 23 % at
// 345 MB/s on one core (26 % as they are; 25 % and 323 MB/s by the bytes of single floats).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"

namespace macula::splat {

// Byte b of element i, of `stride` bytes each, goes to b * elements + i; raw deflate (RFC 1951) of that. The
// data are whole elements, below 4 GiB. outOfMemory when there is none.
Result<std::vector<std::byte>> packPlanes(std::span<const std::byte> data, std::uint32_t stride);

// Unpacks into `data`, of the size that was packed; false when the packed bytes do not give exactly so many,
// or go on behind them. outOfMemory when there is none.
Result<bool> unpackPlanes(std::span<const std::byte> packed, std::uint32_t stride, std::span<std::byte> data);

}  // namespace macula::splat
