// The surface of a segment as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/voxel_set.h"

namespace macula::segment {

// Triangles of three vertices each, counter-clockwise when seen from outside.
struct TriangleMesh {
    std::vector<glm::dvec3> verticesMm;  // patient LPS
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

// In mm³, for a closed mesh; below 0 if its inside is out.
double volumeMm3(const TriangleMesh& mesh);

// By marching tetrahedra: six to each cube of eight voxel centres, with vertices half way between a voxel of
// the set and one beside it. So the mesh is always closed, each of its edges has two triangles, and each
// vertex one fan. ITK's meshes of masks do not promise that. What touches the edge of a volume is closed
// there. `passes` of Taubin's smoothing take the steps off, and keep the volume of what is larger than some
// voxels. Errors: usage for a set without voxels, and for more than kMostTriangles; cancelled; outOfMemory.
inline constexpr std::size_t kMostTriangles = 60'000'000;
Result<TriangleMesh> surfaceOf(const VoxelSet& set, const glm::dmat4& worldFromVoxel, int passes,
                               Progress& progress);

}  // namespace macula::segment
