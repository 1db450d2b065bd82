// Converts between the part of a splat's colour that all directions share and the coefficient that holds it
// (Splats::dc), in linear radiance or display values, as the model's colours are.
#pragma once

#include <glm/glm.hpp>

namespace macula::splat {

inline constexpr float kHarmonic0 = 0.28209479177387814f;  // 1 / (2 sqrt(pi))

template <class T>  // float, or glm::vec3 for three channels
T colourOfDc(const T& dc) {
    return 0.5f + kHarmonic0 * dc;
}

template <class T>
T dcOfColour(const T& colour) {
    return (colour - 0.5f) / kHarmonic0;
}

}  // namespace macula::splat
