// The handles of outlines and lines that were drawn by hand, which have more points than a hand can hold.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace macula::viewer {

enum class Freehand { closed, open };

// Eight points spread over all, or all of them if they are fewer; of a closed one then the middle of all
// points. An open one has one at each end. None for fewer than two points.
std::vector<glm::dvec3> freehandHandles(const std::vector<glm::dvec3>& pointsMm, Freehand kind);

// Moves one of these handles, and the points on each side less and less until the next handle; the middle
// moves all. Moving it back gives the same points. Unchanged for a handle that there is not.
std::vector<glm::dvec3> withFreehandMoved(std::vector<glm::dvec3> pointsMm, std::size_t handle,
                                          const glm::dvec3& byMm, Freehand kind);

}  // namespace macula::viewer
