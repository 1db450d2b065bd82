// Marks that tools lay over the 3D picture: handles of what is seen there, and lines of dots.
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
    heldHandle,  // is pointed at, or held
};

struct ToolMark {
    MarkKind kind = MarkKind::dot;
    glm::dvec2 place{0.0};  // its middle, -1 to 1, right and up are positive

    bool operator==(const ToolMark&) const = default;
};

inline constexpr std::size_t kMostToolMarks = 400;  // each is a copy of its own when the picture is shown

// With marks above what else is of a picture of so many device pixels on a screen of `pixelRatio`; later
// marks lie above earlier ones. What is outside of the picture, no number, or beyond kMostToolMarks is left
// out. `others` itself, which may be null, where no mark is left. Needs a QGuiApplication.
std::shared_ptr<const app::PictureText> withToolMarks(const std::shared_ptr<const app::PictureText>& others,
                                                      std::span<const ToolMark> marks, QSize pixels,
                                                      double pixelRatio);

}  // namespace macula::viewer
