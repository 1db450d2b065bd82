#include "app/choice/typed_values.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "pipeline/trace/settings.h"

namespace macula::app {

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

Result<DisplayWindow> parseWindow(const std::string& text) {
    DisplayWindow window{.center = 0.0, .width = 0.0, .explanation = {}, .function = "LINEAR_EXACT"};
    int used = 0;
    const bool read = std::sscanf(text.c_str(), "%lf,%lf%n", &window.center, &window.width, &used) == 2 &&
                      used == static_cast<int>(text.size());
    if (!read || !std::isfinite(window.center) || !(window.width > 0.0) || !std::isfinite(window.width)) {
        return Error{ErrorCode::usage, "The window is not usable.", text,
                     "Give --window as CENTRE,WIDTH in units of the series, the width above 0."};
    }
    return window;
}

Result<glm::vec3> parseBackground(const std::string& text) {
    glm::vec3 colour(-1.0f);
    int used = 0;
    const bool read = std::sscanf(text.c_str(), "%f,%f,%f%n", &colour.x, &colour.y, &colour.z, &used) == 3 &&
                      used == static_cast<int>(text.size());
    const auto isShare = [](float v) { return v >= 0.0f && v <= 1.0f; };
    if (!read || !isShare(colour.x) || !isShare(colour.y) || !isShare(colour.z)) {
        return Error{ErrorCode::usage, "The background is not usable.", text,
                     "Give --background as R,G,B, each from 0 to 1: 1,1,1 is white."};
    }
    return colour;
}

}  // namespace macula::app
