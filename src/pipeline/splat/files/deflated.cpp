#include "pipeline/splat/files/deflated.h"

#include <limits>
#include <memory>
#include <new>

#include "base/check.h"

namespace macula::splat {

Bytef* zlibBytes(std::span<const std::byte> data) {
    return reinterpret_cast<Bytef*>(const_cast<std::byte*>(data.data()));
}

Error noMemoryToPack() {
    return {ErrorCode::outOfMemory,
            Text("There is no memory to pack or unpack the model."),
            {},
            Text("Close other programs.")};
}

Result<std::vector<std::byte>> deflated(std::span<const std::byte> data, const DeflateSettings& settings,
                                        gz_header* header) {
    MACULA_CHECK_LE(data.size(), std::numeric_limits<uInt>::max());
    z_stream stream{};
    if (deflateInit2(&stream, settings.level, Z_DEFLATED, settings.windowBits, settings.memoryLevel,
                     settings.strategy) != Z_OK)
        return noMemoryToPack();
    const std::unique_ptr<z_stream, int (*)(z_streamp)> end(&stream, deflateEnd);
    if (header != nullptr) deflateSetHeader(&stream, header);
    try {
        std::vector<std::byte> packed(deflateBound(&stream, static_cast<uLong>(data.size())));
        MACULA_CHECK_LE(packed.size(), std::numeric_limits<uInt>::max());
        stream.next_in = zlibBytes(data);
        stream.avail_in = static_cast<uInt>(data.size());
        stream.next_out = reinterpret_cast<Bytef*>(packed.data());
        stream.avail_out = static_cast<uInt>(packed.size());
        if (deflate(&stream, Z_FINISH) != Z_STREAM_END) return noMemoryToPack();
        packed.resize(packed.size() - stream.avail_out);
        return packed;
    } catch (const std::bad_alloc&) {
        return noMemoryToPack();
    }
}

}  // namespace macula::splat
