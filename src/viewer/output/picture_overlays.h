// Overlays of a saved picture: cube, scale, and the letters at the edges. None of them names the patient.
#pragma once

#include <vector>

#include "base/camera.h"
#include "pictures/stamp.h"

namespace macula::viewer {

// Scaled as on a screen of usual size. Pictures too small for cube and scale get only letters; an unusable
// camera gets nothing. `isCalibrated` as in Provenance, of the volume. Needs a QGuiApplication; any thread
// may call it.
std::vector<pictures::Stamp> overlaysOf(const Camera& camera, const glm::ivec2& sizePx, bool isCalibrated);

}  // namespace macula::viewer
