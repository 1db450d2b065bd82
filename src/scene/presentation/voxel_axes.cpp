#include "scene/presentation/voxel_axes.h"

#include <algorithm>

namespace macula::scene {

bool isAlongPatient(const Volume& volume) {
    constexpr double kStraight = 1e-6;
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 axis = glm::abs(glm::normalize(glm::dvec3(volume.worldFromVoxel()[column])));
        if (std::max({axis.x, axis.y, axis.z}) < 1.0 - kStraight * kStraight) return false;
    }
    return true;
}

ValueRange valuesSeen(const DisplayWindow& window) {
    const bool isLinear = window.function.empty() || window.function == "LINEAR";
    // LINEAR spans width - 1 around center - 0.5; at a width of 1 or less it is treated as LINEAR_EXACT.
    const double shift = isLinear && window.width > 1.0 ? 0.5 : 0.0;
    const double width = window.width - 2.0 * shift;
    return {window.center - shift - 0.5 * width, window.center - shift + 0.5 * width};
}

}  // namespace macula::scene
