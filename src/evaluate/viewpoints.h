// The viewpoints of measured frames: all visible matter from the front, the left, and above.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string_view>

#include "base/camera.h"
#include "base/frames.h"

namespace macula::evaluate {

struct Viewpoint {
    ViewDirection from;
    std::string_view name;  // in reports
};
inline constexpr std::array kViewpoints{Viewpoint{ViewDirection::anterior, "anterior"},
                                        Viewpoint{ViewDirection::left, "left"},
                                        Viewpoint{ViewDirection::superior, "superior"}};

inline Camera cameraFrom(const Viewpoint& viewpoint, const Box& seenMm, double verticalFovDeg,
                         const glm::ivec2& sizePx) {
    return frameBox(seenMm, viewpoint.from, verticalFovDeg, double(sizePx.x) / double(sizePx.y));
}

}  // namespace macula::evaluate
