#include "pipeline/splat/files/chunk_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <new>
#include <optional>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/splat/files/byte_planes.h"
#include "pipeline/splat/files/gzip.h"

namespace macula::splat {

namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they are in memory");

constexpr std::size_t kMostName = 8;
constexpr std::uint32_t kMostStride = 256;
constexpr std::uint64_t kWorthThreads = std::uint64_t(1) << 20;

struct FileHead {
    std::array<char, 8> magic{};
    std::uint32_t version = 0;
    std::uint32_t chunks = 0;
};
static_assert(sizeof(FileHead) == 16);

struct ChunkHead {
    std::array<char, kMostName> name{};
    std::uint64_t storedBytes = 0;
    std::uint64_t plainBytes = 0;
    std::uint32_t stride = 0;
    std::uint32_t crc = 0;
    std::uint32_t headCrc = 0;
    std::uint32_t zero = 0;
};
static_assert(sizeof(ChunkHead) == 40);

std::uint32_t headCrcOf(const ChunkHead& head) {
    return checksum(std::as_bytes(std::span(&head, 1)).first(offsetof(ChunkHead, headCrc)));
}

template <class T>
bool readOne(std::istream& stream, T& value) {
    stream.read(reinterpret_cast<char*>(&value), sizeof(T));
    return static_cast<std::size_t>(stream.gcount()) == sizeof(T);
}

// Whether a chunk with this head is possible in a file that has `left` more bytes.
bool isPossible(const ChunkHead& head, std::uint64_t left) {
    if (head.headCrc != headCrcOf(head) || head.zero != 0 || head.storedBytes > left) return false;
    if (head.stride == 0) return head.plainBytes == head.storedBytes;
    return head.stride <= kMostStride && head.plainBytes % head.stride == 0 &&
           head.plainBytes / kMostDeflated <= head.storedBytes;
}

std::string nameOf(const ChunkHead& head) {
    return {head.name.begin(), std::find(head.name.begin(), head.name.end(), '\0')};
}

// A vector of that size; nothing if memory runs out, so that the caller can return an error.
std::optional<std::vector<std::byte>> room(std::uint64_t bytes) {
    try {
        return std::vector<std::byte>(bytes);
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    return std::nullopt;
}

Error noMemory() {
    return {
        ErrorCode::outOfMemory, Text("There is no memory for the model."), {}, Text("Close other programs.")};
}

}  // namespace

std::uint32_t checksum(std::span<const std::byte> bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

Error damagedModel() {
    return {ErrorCode::inputNotUsable,
            Text("The model is damaged or cut off."),
            {},
            Text("Copy it again, or train it again.")};
}

void forEachChunk(std::size_t count, std::uint64_t bytes, const std::function<void(std::size_t)>& body) {
    if (bytes >= kWorthThreads) return parallelFor(count, body);
    for (std::size_t i = 0; i < count; ++i) body(i);
}

Result<void> writeChunks(std::ostream& stream, std::uint32_t version, std::span<const Chunk> chunks) {
    std::vector<Result<std::vector<std::byte>>> packed(chunks.size(), std::vector<std::byte>{});
    std::uint64_t total = 0;
    const auto isToPack = [](const Chunk& chunk) { return chunk.stride > 0 && chunk.packed.empty(); };
    for (const Chunk& chunk : chunks) total += isToPack(chunk) ? chunk.bytes.size() : 0;
    forEachChunk(chunks.size(), total, [&](std::size_t i) {
        if (isToPack(chunks[i])) packed[i] = packPlanes(chunks[i].bytes, chunks[i].stride);
    });
    const auto write = [&](const void* bytes, std::size_t size) {
        stream.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    };
    FileHead file{.version = version, .chunks = static_cast<std::uint32_t>(chunks.size())};
    std::copy(kChunkFileMagic.begin(), kChunkFileMagic.end(), file.magic.begin());
    write(&file, sizeof(file));
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        const Chunk& chunk = chunks[i];
        MACULA_CHECK(!chunk.name.empty() && chunk.name.size() <= kMostName && chunk.stride <= kMostStride);
        if (!packed[i].ok()) return packed[i].error();
        std::span<const std::byte> stored = chunk.bytes;
        if (chunk.stride > 0)
            stored = isToPack(chunk) ? std::span<const std::byte>(*packed[i]) : chunk.packed;
        ChunkHead head{.storedBytes = stored.size(),
                       .plainBytes = chunk.bytes.size(),
                       .stride = chunk.stride,
                       .crc = checksum(stored)};
        std::copy(chunk.name.begin(), chunk.name.end(), head.name.begin());
        head.headCrc = headCrcOf(head);
        write(&head, sizeof(head));
        write(stored.data(), stored.size());
    }
    stream.flush();
    if (!stream)
        return Error{ErrorCode::outputNotWritable,
                     Text("The model could not be written."),
                     {},
                     Text("Check free space and permissions.")};
    return {};
}

Result<ChunkFile> ChunkFile::open(std::istream& stream, std::uint64_t size, std::uint32_t version) {
    return openUntil(stream, size, version, {});  // no name: to the end
}

Result<ChunkFile> ChunkFile::openUntil(std::istream& stream, std::uint64_t size, std::uint32_t version,
                                       std::string_view last) {
    FileHead file;
    stream.clear();
    stream.seekg(0);
    if (!readOne(stream, file)) return damagedModel();
    if (std::string_view(file.magic.data(), file.magic.size()) != kChunkFileMagic) return damagedModel();
    if (file.version != version)
        return Error{ErrorCode::inputNotUsable,
                     Text("The model is a .macula file of version {}; this Macula reads version {}.",
                          file.version, version),
                     {},
                     file.version > version ? Text("Use a newer Macula, or export the model as PLY there.")
                                            : Text("Export it as PLY with the Macula that made it.")};
    std::uint64_t offset = sizeof(FileHead);
    std::vector<ChunkEntry> entries;
    for (std::uint32_t i = 0; i < file.chunks; ++i) {
        ChunkHead head;
        if (size - offset < sizeof(head) || !readOne(stream, head)) return damagedModel();
        offset += sizeof(head);
        if (!isPossible(head, size - offset)) return damagedModel();
        entries.push_back({.name = nameOf(head),
                           .offset = offset,
                           .storedBytes = head.storedBytes,
                           .plainBytes = head.plainBytes,
                           .stride = head.stride,
                           .crc = head.crc});
        if (!last.empty() && entries.back().name == last) return ChunkFile(stream, std::move(entries));
        offset += head.storedBytes;
        stream.seekg(static_cast<std::streamoff>(offset));
    }
    if (offset != size) return damagedModel();
    return ChunkFile(stream, std::move(entries));
}

bool ChunkFile::has(std::string_view name) const {
    return std::any_of(entries_.begin(), entries_.end(),
                       [&](const ChunkEntry& entry) { return entry.name == name; });
}

Result<const ChunkEntry*> ChunkFile::only(std::string_view name) const {
    const auto isNamed = [&](const ChunkEntry& entry) { return entry.name == name; };
    const auto found = std::find_if(entries_.begin(), entries_.end(), isNamed);
    if (std::count_if(entries_.begin(), entries_.end(), isNamed) != 1) return damagedModel();
    return &*found;
}

Result<std::vector<std::byte>> ChunkFile::stored(const ChunkEntry& entry) {
    auto bytes = room(entry.storedBytes);
    if (!bytes) return noMemory();
    stream_->clear();
    stream_->seekg(static_cast<std::streamoff>(entry.offset));
    stream_->read(reinterpret_cast<char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
    if (static_cast<std::uint64_t>(stream_->gcount()) != entry.storedBytes || checksum(*bytes) != entry.crc)
        return damagedModel();
    return std::move(*bytes);
}

Result<std::vector<std::byte>> ChunkFile::unpacked(const ChunkEntry& entry, std::vector<std::byte> stored) {
    if (entry.stride == 0) return stored;
    auto plain = room(entry.plainBytes);
    if (!plain) return noMemory();
    MACULA_TRY(const bool whole, unpackPlanes(stored, entry.stride, *plain));
    if (!whole) return damagedModel();
    return std::move(*plain);
}

Result<std::vector<std::byte>> ChunkFile::read(std::string_view name, std::uint64_t bytes) {
    MACULA_TRY(const ChunkEntry* entry, only(name));
    if (entry->plainBytes != bytes) return damagedModel();
    MACULA_TRY(std::vector<std::byte> packed, stored(*entry));
    return unpacked(*entry, std::move(packed));
}

Result<std::string> ChunkFile::readText(std::string_view name) {
    MACULA_TRY(const ChunkEntry* entry, only(name));
    MACULA_TRY(const std::vector<std::byte> bytes, read(name, entry->plainBytes));
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

}  // namespace macula::splat
