// Empty-space leaping: how far each empty brick is from matter.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace macula {

inline constexpr int kMaxLeap = 255;  // bricks

// `bounds` has a majorant for each brick, x fastest. Replaces those that are not above 0 by minus the
// Chebyshev distance in bricks to the nearest one that is, at most kMaxLeap: shaders/lib/brick_walk.glsl
// leaps so far. Outside the grid is empty. Uses all cores.
void measureEmptySpace(glm::ivec3 gridSize, std::span<float> bounds);

}  // namespace macula
