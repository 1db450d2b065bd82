// deflate (RFC 1951) in memory, in one call of zlib: shared by gzip and packed planes.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <span>
#include <vector>

#include "base/result.h"

namespace macula::splat {

// The parameters of zlib's deflateInit2.
struct DeflateSettings {
    int level;
    int windowBits;  // negative: raw; + 16: gzip
    int memoryLevel;
    int strategy;
};

// Removes const, because zlib's input pointer lacks it although zlib only reads there.
Bytef* zlibBytes(std::span<const std::byte> data);

// The error of packing and unpacking when memory runs out.
Error noMemoryToPack();

// Packs `data`, below 4 GiB. `header` is gzip's. Fails with noMemoryToPack.
Result<std::vector<std::byte>> deflated(std::span<const std::byte> data, const DeflateSettings& settings,
                                        gz_header* header = nullptr);

}  // namespace macula::splat
