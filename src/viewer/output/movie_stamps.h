// Texts over the pictures of a sequence.
#pragma once

#include <string>
#include <vector>

#include "pictures/stamp.h"
#include "scene/camera/orbit_camera.h"

namespace macula::viewer {

// Puts `lines` in the upper left corner, and the sides of the patient at the middle of each edge; both may be
// empty. Sizes scale with the picture's height. Needs a QGuiApplication; any thread may call it.
std::vector<pictures::Stamp> stampsOf(const std::vector<std::string>& lines,
                                      const scene::EdgeLetters& letters, const glm::ivec2& sizePx);

}  // namespace macula::viewer
