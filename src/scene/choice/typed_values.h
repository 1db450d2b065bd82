// Parses typed values of several numbers. Each function fails with usage for any other text.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "base/result.h"
#include "base/volume.h"

namespace macula::scene {

// --size WIDTHxHEIGHT: in pixels, each from 1 to trace::kMaxPictureSide.
Result<glm::ivec2> parseSize(const std::string& text);

// --window CENTRE,WIDTH: as DICOM's LINEAR_EXACT, black at centre - width / 2, white at centre + width / 2;
// the width above 0.
Result<DisplayWindow> parseWindow(const std::string& text);

// --background R,G,B: each from 0 to 1.
Result<glm::vec3> parseBackground(const std::string& text);

}  // namespace macula::scene
