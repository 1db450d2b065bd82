// The keys that move the camera of the 3D picture.
#pragma once

#include <functional>

#include "viewer/viewport/picture_camera.h"

class QKeyEvent;

namespace macula::viewer {

class CameraKeys {
  public:
    // The camera outlives this. `nudge` is called before a step of a key that may be held down.
    CameraKeys(PictureCamera& camera, std::function<void()> nudge);

    // Each returns whether it handled the key. roll(): [, ] and Ctrl with arrows. move(): arrows. look():
    // standard views, fit, parallel, + and -. Call move() and look() only without modifiers other than Shift.
    bool roll(const QKeyEvent& event);
    bool move(const QKeyEvent& event);
    bool look(const QKeyEvent& event);

  private:
    PictureCamera& camera_;
    std::function<void()> nudge_;
};

}  // namespace macula::viewer
