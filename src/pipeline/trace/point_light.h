// The light of surface points, which share their paths with neighbours and so have less noise.
#pragma once

#include <span>

#include "pipeline/trace/surface_points.h"

namespace macula::trace {

// Light that leaves a point, and coverage, summed over its paths.
struct GatheredLight {
    glm::dvec3 radiance{0.0};
    double coverage = 0.0;
};

// Writes the radiance of each point. Neighbours that face the same way show nearly the same light, and share
// their paths: on a surface two dozen points do. `gathered` has one entry for each point.
void shareLight(std::span<SurfacePoint> points, std::span<const GatheredLight> gathered);

}  // namespace macula::trace
