// A file of named chunks, each with a checksum: the format of .macula files (training_file.h).
//
//  Numbers are little-endian.
//    8 bytes  "MACULA", 0x1a, 0x0a: reveals a file that was transferred as text
//    u32      version of the format of the chunks' content
//    u32      number of chunks
//  and then for each chunk, one after another up to the end of the file:
//    8 bytes  name in ASCII, filled up with zeros
//    u64      bytes in the file
//    u64      bytes unpacked
//    u32      stride: 0: not packed; else packed in planes of that stride, see byte_planes.h
//    u32      CRC-32 (that of zlib and gzip) of the bytes in the file
//    u32      CRC-32 of the 32 bytes of this head so far
//    u32      0
//    the bytes
//  So no change of a single byte passes unnoticed, except in the version, and a chunk can be found without
//  reading the others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <istream>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/result.h"

namespace macula::splat {

inline constexpr std::string_view kChunkFileMagic("MACULA\x1a\n", 8);

struct Chunk {
    std::string name;                  // 1 to 8 characters; several chunks may have the same name
    std::span<const std::byte> bytes;  // whole elements of the stride, below 4 GiB when packed
    std::uint32_t stride = 0;
    std::span<const std::byte> packed;  // `bytes` packed by packPlanes, if known; else empty
};

// Packs chunks that are not packed yet, on all cores. Fails with outOfMemory, or outputNotWritable when the
// stream fails.
Result<void> writeChunks(std::ostream& stream, std::uint32_t version, std::span<const Chunk> chunks);

struct ChunkEntry {
    std::string name;
    std::uint64_t offset = 0;  // where its bytes begin in the file
    std::uint64_t storedBytes = 0;
    std::uint64_t plainBytes = 0;
    std::uint32_t stride = 0;
    std::uint32_t crc = 0;
};

// All functions fail with inputNotUsable when the file is damaged or cut off, and allocate no more memory
// than a file of that size can fill.
class ChunkFile {
  public:
    // Reads the heads. The stream, of `size` bytes, must outlive this. Also fails when the file is of another
    // kind or version; the error names both versions.
    static Result<ChunkFile> open(std::istream& stream, std::uint64_t size, std::uint32_t version);
    // Reads heads only up to the first chunk named `last`, all if there is none: damage after that chunk goes
    // unnoticed.
    static Result<ChunkFile> openUntil(std::istream& stream, std::uint64_t size, std::uint32_t version,
                                       std::string_view last);

    const std::vector<ChunkEntry>& entries() const { return entries_; }

    // The bytes of a chunk as they are in the file.
    Result<std::vector<std::byte>> stored(const ChunkEntry& entry);
    // Unpacks the result of stored(). Any thread may call it. Fails with outOfMemory.
    static Result<std::vector<std::byte>> unpacked(const ChunkEntry& entry, std::vector<std::byte> stored);

    // The only chunk of that name, unpacked; it must have exactly `bytes` bytes.
    Result<std::vector<std::byte>> read(std::string_view name, std::uint64_t bytes);
    // The same as text of any size.
    Result<std::string> readText(std::string_view name);
    // The same as an array of `count` elements.
    template <class T>
    Result<std::vector<T>> readArray(std::string_view name, std::uint64_t count) {
        static_assert(std::is_trivially_copyable_v<T>);
        MACULA_TRY(const std::vector<std::byte> bytes, read(name, count * sizeof(T)));
        std::vector<T> values(count);
        if (count > 0) std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }
    bool has(std::string_view name) const;

  private:
    ChunkFile(std::istream& stream, std::vector<ChunkEntry> entries)
        : stream_(&stream), entries_(std::move(entries)) {}
    Result<const ChunkEntry*> only(std::string_view name) const;

    std::istream* stream_;
    std::vector<ChunkEntry> entries_;
};

// Calls body(i) for each chunk, on all cores if `bytes`, the size of all chunks, is worth that.
void forEachChunk(std::size_t count, std::uint64_t bytes, const std::function<void(std::size_t)>& body);

// CRC-32, that of zlib and gzip.
std::uint32_t checksum(std::span<const std::byte> bytes);

// The error for any damage of a model's file.
Error damagedModel();

}  // namespace macula::splat
