// deflate (RFC 1951) in memory, all at once, by zlib: what gzip and packed planes have in common.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <span>
#include <vector>

#include "base/result.h"

namespace macula::splat {

// zlib's words for it (deflateInit2).
struct DeflateSettings {
    int level;
    int windowBits;  // negative: raw; + 16: gzip
    int memoryLevel;
    int strategy;
};

// zlib takes what it only reads without const.
Bytef* zlibBytes(std::span<const std::byte> data);

// What all of these say when there is no memory.
Error noMemoryToPack();

// `data` is below 4 GiB. The header is of gzip. Fails with noMemoryToPack.
Result<std::vector<std::byte>> deflated(std::span<const std::byte> data, const DeflateSettings& settings,
                                        gz_header* header = nullptr);

}  // namespace macula::splat
