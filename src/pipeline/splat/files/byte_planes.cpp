#include "pipeline/splat/files/byte_planes.h"

#include <zlib.h>

#include <limits>
#include <new>

#include "base/check.h"
#include "pipeline/splat/files/deflated.h"

namespace macula::splat {

namespace {

constexpr int kRawDeflate = -MAX_WBITS;
constexpr int kMemoryLevel = 9;

Result<std::vector<std::byte>> pack(std::span<const std::byte> data, std::uint32_t stride) {
    MACULA_CHECK_LT(0u, stride);
    MACULA_CHECK_EQ(data.size() % stride, 0u);
    const std::size_t elements = data.size() / stride;
    std::vector<std::byte> planes(data.size());
    for (std::size_t b = 0; b < stride; ++b)
        for (std::size_t i = 0; i < elements; ++i) planes[b * elements + i] = data[i * stride + b];
    return deflated(planes, {Z_BEST_SPEED, kRawDeflate, kMemoryLevel, Z_RLE});
}

Result<bool> unpack(std::span<const std::byte> packed, std::uint32_t stride, std::span<std::byte> data) {
    constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
    if (packed.size() > kMost || data.size() > kMost || stride == 0 || data.size() % stride != 0)
        return false;
    z_stream stream{};
    std::vector<std::byte> planes(data.size());
    if (inflateInit2(&stream, kRawDeflate) != Z_OK) return noMemoryToPack();
    std::byte none{};  // zlib needs a valid pointer even for no output
    stream.next_in = zlibBytes(packed);
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(planes.empty() ? &none : planes.data());
    stream.avail_out = static_cast<uInt>(planes.size());
    const int status = inflate(&stream, Z_FINISH);
    const bool exact = status == Z_STREAM_END && stream.avail_in == 0 && stream.avail_out == 0;
    inflateEnd(&stream);
    if (!exact) return false;
    const std::size_t elements = data.size() / stride;
    for (std::size_t b = 0; b < stride; ++b)
        for (std::size_t i = 0; i < elements; ++i) data[i * stride + b] = planes[b * elements + i];
    return true;
}

}  // namespace

// Chunks are packed in parallel, on threads that must not throw.
Result<std::vector<std::byte>> packPlanes(std::span<const std::byte> data, std::uint32_t stride) {
    try {
        return pack(data, stride);
    } catch (const std::bad_alloc&) {
        return noMemoryToPack();
    }
}

Result<bool> unpackPlanes(std::span<const std::byte> packed, std::uint32_t stride,
                          std::span<std::byte> data) {
    try {
        return unpack(packed, stride, data);
    } catch (const std::bad_alloc&) {
        return noMemoryToPack();
    }
}

}  // namespace macula::splat
