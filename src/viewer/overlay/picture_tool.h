// Tools of the 3D picture, which get mouse input before the camera does.
#pragma once

#include <QCursor>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/camera.h"
#include "viewer/overlay/tool_marks.h"

namespace macula::viewer {

// Camera and shape of the requested 3D picture. A tool can take hold only once that picture is on screen.
struct PictureGeometry {
    Camera camera;
    double aspect = 1.0;     // width over height
    glm::dvec2 sizePx{1.0};  // logical
};

// A place in the picture: -1 to 1, right and up are positive.
struct PicturePlace {
    PictureGeometry picture;
    glm::dvec2 at{0.0};
    bool withShift = false;
};

// Called by the viewport on the UI thread. A tool that takes hold gets all moves until the button is released
// or the hold is given up.
class PictureTool {
  public:
    virtual ~PictureTool() = default;

    virtual bool press(const PicturePlace& place) = 0;  // left button; returns whether it takes hold
    virtual void move(const PicturePlace& place) = 0;   // while it holds
    virtual void release(const PicturePlace& place) = 0;
    virtual void giveUp() = 0;
    // Whether a drag changes the picture; then frames must be fast.
    virtual bool changesPicture() const = 0;

    // The cursor over `place` while no tool holds; nothing: the usual one.
    virtual std::optional<Qt::CursorShape> point(const PicturePlace& place) = 0;
    // The wheel with Shift. Returns whether the tool used it.
    virtual bool turnWheel(double notches, const PictureGeometry& picture) = 0;
    virtual std::vector<ToolMark> marks(const PictureGeometry& picture) const = 0;
};

}  // namespace macula::viewer
