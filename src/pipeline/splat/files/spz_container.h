// The container of SPZ version 4 (github.com/nianticlabs/spz, extensions/README.md, and what its readers
// agree on): a header of 32 bytes, of which the first 16 are those of earlier versions, with the number of
// streams in the last of them, then the offset of the table of contents (u32) and 12 zeros; vendors' records
// (spz_records.h); the table, with the packed and unpacked size (u64) of each stream; the streams, one zstd
// frame each. Numbers are little endian; only the streams are packed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/files/spz_records.h"

namespace macula::splat {

inline constexpr std::size_t kSpzHeaderBytes = 16;

// `header` is the first 16 bytes; this sets its flag for records and its number of streams. `notes` become a
// record of Macula's own type, which other programs skip. The streams are in `data`, one after another, and
// have these sizes; empty ones are left out. The same data give the same bytes. Fails with outOfMemory.
Result<std::vector<std::byte>> packSpzStreams(std::array<std::byte, kSpzHeaderBytes> header,
                                              const std::string& notes, std::span<const std::byte> data,
                                              std::span<const std::size_t> sizes);

// Fills `records`, and `data` with the streams, which must have these sizes. False when the file is cut off
// or damaged, or its streams have other sizes.
bool unpackSpzStreams(std::span<const std::byte> file, std::span<const std::size_t> sizes,
                      std::span<std::byte> data, SpzRecords& records);

}  // namespace macula::splat
