// The way along a vessel, or another tube of similar values, between places that a person has set in it.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::segment {

// The most voxels that are searched between two places.
inline constexpr std::size_t kMostSearchedVoxels = std::size_t{1} << 25;

// From the first place to the last through all others, in patient LPS mm; points are some millimetres apart.
// Between two places it is the cheapest path over neighbouring voxels (A*, Hart, Nilsson and Raphael, 1968):
// a step costs its length, and more the further the mean of the 27 voxels around differs from that at the two
// places. It then moves to the middle of similar values around it. Errors: usage without two places in the
// volume, or if they are so far apart that more than kMostSearchedVoxels lie between; cancelled.
Result<std::vector<glm::dvec3>> vesselPath(const Volume& volume, std::span<const glm::dvec3> placesMm,
                                           const CancelToken& token);

}  // namespace macula::segment
