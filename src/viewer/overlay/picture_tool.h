// What a hand does in the 3D picture before it moves the camera.
#pragma once

#include <QCursor>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/camera.h"
#include "viewer/overlay/tool_marks.h"

namespace macula::viewer {

// Camera and shape of the 3D picture that is asked for. A tool takes hold only once that one is on screen.
struct PictureGeometry {
    Camera camera;
    double aspect = 1.0;     // width over height
    glm::dvec2 sizePx{1.0};  // logical
};

// A place in it: -1 to 1, right and up are positive.
struct PicturePlace {
    PictureGeometry picture;
    glm::dvec2 at{0.0};
    bool withShift = false;
};

// Asked by the viewport, on the UI thread. A tool that takes hold gets all moves until the button is released
// or the hold is given up.
class PictureTool {
  public:
    virtual ~PictureTool() = default;

    virtual bool press(const PicturePlace& place) = 0;  // with the left button; whether it takes hold
    virtual void move(const PicturePlace& place) = 0;   // while it holds
    virtual void release(const PicturePlace& place) = 0;
    virtual void giveUp() = 0;
    // Whether what it holds changes the picture: then pictures are to be fast.
    virtual bool changesPicture() const = 0;

    // Nobody holds anything. What the pointer looks like there; nothing: as always.
    virtual std::optional<Qt::CursorShape> point(const PicturePlace& place) = 0;
    // With Shift. Whether it was meant for it.
    virtual bool turnWheel(double notches, const PictureGeometry& picture) = 0;
    virtual std::vector<ToolMark> marks(const PictureGeometry& picture) const = 0;
};

}  // namespace macula::viewer
