// Marks that tools draw over the 3D picture: handles, and lines of dots.
#pragma once

#include <QSize>
#include <glm/glm.hpp>
#include <memory>
#include <span>

#include "live/frame/picture_text.h"

namespace macula::viewer {

enum class MarkKind {
    dot,         // of a line
    drawnDot,    // of a line that is being drawn
    handle,      // moves along a line
    freeHandle,  // moves anywhere
    heldHandle,  // pointed at or held
};

struct ToolMark {
    MarkKind kind = MarkKind::dot;
    glm::dvec2 place{0.0};  // its middle, -1 to 1, right and up are positive

    bool operator==(const ToolMark&) const = default;
};

inline constexpr std::size_t kMostToolMarks = 400;  // each is copied separately

// Adds marks above `others`, for a picture of `pixels` device pixels on a screen of `pixelRatio`; later marks
// lie above earlier ones. Leaves out marks outside the picture, not finite, or beyond kMostToolMarks. Returns
// `others`, which may be null, if no mark is left. Needs a QGuiApplication.
std::shared_ptr<const live::PictureText> withToolMarks(const std::shared_ptr<const live::PictureText>& others,
                                                       std::span<const ToolMark> marks, QSize pixels,
                                                       double pixelRatio);

}  // namespace macula::viewer
