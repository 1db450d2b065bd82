// Points that fill a square more evenly than chance does.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace macula::hybrid {

// Point `index` of the first two dimensions of the Sobol sequence (Sobol 1967), scrambled so that the points
// of each seed are each even in [0, 1)^2 and together as well spread as before: nested uniform scrambling
// (Owen 1995). Of any 2^k points from a multiple of 2^k on, one lies in each elementary interval of area
// 2^-k. `index` below 2^32.
glm::dvec2 scrambledSobol(std::uint32_t index, std::uint64_t seed);

}  // namespace macula::hybrid
