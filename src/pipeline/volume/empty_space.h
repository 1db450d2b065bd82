// Empty-space leaping: how far each empty brick is from matter.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace macula {

inline constexpr int kMaxLeap = 255;  // bricks

// `bounds` is by brick, x fastest. Whatever is not above 0 is replaced by minus the Chebyshev distance in
// bricks to the nearest that is, at most kMaxLeap: what shaders/lib/brick_walk.glsl leaps over. Outside the
// grid is empty. On all cores.
void measureEmptySpace(glm::ivec3 gridSize, std::span<float> bounds);

}  // namespace macula
