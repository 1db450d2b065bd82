// --size WIDTHxHEIGHT.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "base/result.h"

namespace macula::cli {

// In pixels, each from 1 to trace::kMaxPictureSide; fails with usage for anything else.
Result<glm::ivec2> parseSize(const std::string& text);

}  // namespace macula::cli
