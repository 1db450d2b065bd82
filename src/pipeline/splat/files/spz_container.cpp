#include "pipeline/splat/files/spz_container.h"

#include <zstd.h>

#include <cstring>
#include <memory>

#include "base/check.h"

namespace macula::splat {

namespace {

constexpr std::size_t kWholeHeaderBytes = 32;
constexpr std::size_t kFlags = 14;
constexpr std::size_t kStreams = 15;
constexpr std::size_t kTableOffset = 16;
constexpr std::size_t kTableEntryBytes = 16;
constexpr std::byte kHasExtensions{2};

// A compression level that the reference writer uses too; higher ones take much longer to save one percent.
constexpr int kLevel = 12;

template <class T>
void add(std::vector<std::byte>& out, T value) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    out.insert(out.end(), bytes.begin(), bytes.end());
}

template <class T>
T at(std::span<const std::byte> bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

Error noMemory() {
    return {ErrorCode::outOfMemory,
            Text("The model does not fit into memory."),
            {},
            Text("Close other programs.")};
}

}  // namespace

Result<std::vector<std::byte>> packSpzStreams(std::array<std::byte, kSpzHeaderBytes> header,
                                              const std::string& notes, std::span<const std::byte> data,
                                              std::span<const std::size_t> sizes) {
    const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), &ZSTD_freeCCtx);
    if (!context) return noMemory();
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);  // reveals damage

    std::vector<std::byte> table;
    std::vector<std::byte> streams;
    std::size_t count = 0;
    for (const std::size_t size : sizes) {
        MACULA_CHECK_LE(size, data.size());
        const auto stream = data.first(size);
        data = data.subspan(size);
        if (size == 0) continue;
        const std::size_t before = streams.size();
        streams.resize(before + ZSTD_compressBound(size));
        const std::size_t packed = ZSTD_compress2(context.get(), streams.data() + before,
                                                  streams.size() - before, stream.data(), stream.size());
        // Room and parameters are right, so only a lack of memory can fail here.
        if (ZSTD_isError(packed) != 0) return noMemory();
        streams.resize(before + packed);
        add(table, std::uint64_t{packed});
        add(table, std::uint64_t{size});
        ++count;
    }
    if (!notes.empty()) header[kFlags] |= kHasExtensions;
    header[kStreams] = static_cast<std::byte>(count);

    std::vector<std::byte> out(header.begin(), header.end());
    const std::vector<std::byte> zone = notes.empty() ? std::vector<std::byte>() : spzNotesRecord(notes);
    add(out, static_cast<std::uint32_t>(kWholeHeaderBytes + zone.size()));
    out.resize(kWholeHeaderBytes);
    out.insert(out.end(), zone.begin(), zone.end());
    out.insert(out.end(), table.begin(), table.end());
    out.insert(out.end(), streams.begin(), streams.end());
    return out;
}

bool unpackSpzStreams(std::span<const std::byte> file, std::span<const std::size_t> sizes,
                      std::span<std::byte> data, SpzRecords& records) {
    if (file.size() < kWholeHeaderBytes) return false;
    const std::size_t table = at<std::uint32_t>(file, kTableOffset);
    const auto count = std::to_integer<std::size_t>(file[kStreams]);
    if (table < kWholeHeaderBytes || table > file.size() || file.size() - table < count * kTableEntryBytes)
        return false;
    if ((file[kFlags] & kHasExtensions) != std::byte{0})
        records = readSpzRecords(file.subspan(kWholeHeaderBytes, table - kWholeHeaderBytes));

    std::span<const std::byte> packed = file.subspan(table + count * kTableEntryBytes);
    std::size_t entry = 0;
    for (const std::size_t size : sizes) {
        if (size == 0) continue;
        if (entry == count) return false;
        const auto packedSize = at<std::uint64_t>(file, table + entry * kTableEntryBytes);
        const auto unpackedSize = at<std::uint64_t>(file, table + entry * kTableEntryBytes + 8);
        ++entry;
        if (packedSize > packed.size() || unpackedSize != size) return false;
        MACULA_CHECK_LE(size, data.size());
        // Never writes more than `size` bytes, whatever the frame claims.
        if (ZSTD_decompress(data.data(), size, packed.data(), packedSize) != size) return false;
        packed = packed.subspan(packedSize);
        data = data.subspan(size);
    }
    return entry == count;
}

}  // namespace macula::splat
