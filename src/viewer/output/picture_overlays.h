// What is laid over a picture that is saved: the cube, the scale, and the letters at the edges. Nothing of it
// says who is shown.
#pragma once

#include <vector>

#include "base/camera.h"
#include "pictures/stamp.h"

namespace macula::viewer {

// As large in the picture as on a screen of usual size. Pictures that are too small for cube and scale have
// letters alone; a camera that is none has nothing. `isCalibrated` as in Provenance, of the volume. Needs a
// QGuiApplication; any thread may call it.
std::vector<app::Stamp> overlaysOf(const Camera& camera, const glm::ivec2& sizePx, bool isCalibrated);

}  // namespace macula::viewer
