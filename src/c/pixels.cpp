#include "c/pixels.h"

#include "c/last_error.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::c {

Result<void> checkSize(std::int32_t width, std::int32_t height) {
    if (width >= 1 && height >= 1 && width <= trace::kMaxPictureSide && height <= trace::kMaxPictureSide)
        return {};
    return badArgument(Text("The picture cannot have that size."),
                       Text("Take 1 to {} pixels for each side.", trace::kMaxPictureSide));
}

Result<std::uint64_t> rowBytesOf(const Pixels& pixels, std::int32_t width, std::int32_t height) {
    const std::uint64_t row = 4 * std::uint64_t(width);
    const std::uint64_t rowBytes = pixels.rowBytes == 0 ? row : pixels.rowBytes;
    // The last row may end at its last pixel. Divides, as a product of the caller's numbers may overflow.
    const bool hasRoom = pixels.rgba != nullptr && rowBytes >= row && pixels.bytes >= row &&
                         (pixels.bytes - row) / rowBytes >= std::uint64_t(height) - 1;
    if (!hasRoom)
        return badArgument(Text("There is no room for the pixels."),
                           Text("Give {} bytes, in rows of {} or more.", row * std::uint64_t(height), row));
    return rowBytes;
}

}  // namespace macula::c
