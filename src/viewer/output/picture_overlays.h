// What is drawn over saved pictures and movies: texts, cube, scale, and the letters at the edges.
#pragma once

#include <string>
#include <vector>

#include "base/camera.h"
#include "pictures/stamp.h"
#include "scene/camera/orbit_camera.h"

namespace macula::viewer {

// Puts `lines` in the upper left corner, and the sides of the patient at the middle of each edge; both may be
// empty. Sizes scale with the picture's height. Needs a QGuiApplication; any thread may call it.
std::vector<pictures::Stamp> stampsOf(const std::vector<std::string>& lines,
                                      const scene::EdgeLetters& letters, const glm::ivec2& sizePx);

// Cube, scale, and the letters at the edges, none of which names the patient. Scaled as on a screen of usual
// size. Pictures too small for cube and scale get only letters; an unusable camera gets nothing.
// `isCalibrated` as in Provenance, of the volume. Needs a QGuiApplication; any thread may call it.
std::vector<pictures::Stamp> overlaysOf(const Camera& camera, const glm::ivec2& sizePx, bool isCalibrated);

}  // namespace macula::viewer
