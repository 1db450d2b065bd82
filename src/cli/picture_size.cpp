#include "cli/picture_size.h"

#include <algorithm>
#include <cstdio>

#include "pipeline/trace/settings.h"

namespace macula::cli {

Result<glm::ivec2> parseSize(const std::string& text) {
    glm::ivec2 size(0);
    int used = 0;
    // %n tells how much was read: "640x480garbage" is no size.
    const bool read = std::sscanf(text.c_str(), "%6dx%6d%n", &size.x, &size.y, &used) == 2 &&
                      used == static_cast<int>(text.size());
    if (!read || std::min(size.x, size.y) < 1 || std::max(size.x, size.y) > trace::kMaxPictureSide) {
        return Error{
            ErrorCode::usage, "The size of the picture is not usable.", text,
            fmt::format("Give --size as WIDTHxHEIGHT in pixels, each from 1 to {}.", trace::kMaxPictureSide)};
    }
    return size;
}

}  // namespace macula::cli
