// Points that fill a square more evenly than random ones.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace macula::hybrid {

// Point `index` of the first two dimensions of the Sobol sequence (Sobol 1967), with nested uniform
// scrambling (Owen 1995): over the seeds each point is uniform in [0, 1)^2, and the points of one seed are as
// well spread as the sequence. Of any 2^k points from a multiple of 2^k on, one lies in each elementary
// interval of area 2^-k.
glm::dvec2 scrambledSobol(std::uint32_t index, std::uint64_t seed);

}  // namespace macula::hybrid
