// Packs numbers without loss: the first bytes of all numbers, then all second bytes, and so on, by deflate.
//
// Bytes of the same rank are alike: the signs and exponents of a picture's pixels are, their last digits are
// noise, and empty pixels are 0. With only runs and Huffman codes (Z_RLE) deflate packs such planes as well
// as with matches, in a third of the time: pictures of 8 samples, 64 % empty, shrink to 23 % at 345 MB/s on
// one core (26 % without planes; 25 % at 323 MB/s with planes of single floats).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"

namespace macula::splat {

// Puts byte b of element i, of `stride` bytes each, at b * elements + i, and packs the result by raw deflate
// (RFC 1951). The data must be whole elements, below 4 GiB. outOfMemory if memory runs out.
Result<std::vector<std::byte>> packPlanes(std::span<const std::byte> data, std::uint32_t stride);

// Unpacks into `data`, of the size that was packed. False when the packed bytes give fewer or more bytes, or
// continue after their end. outOfMemory if memory runs out.
Result<bool> unpackPlanes(std::span<const std::byte> packed, std::uint32_t stride, std::span<std::byte> data);

}  // namespace macula::splat
