// The first peripheral model: splats from points on the surface, before any training. It is what a person
// sees first, and what the trainer starts from.
#pragma once

#include "pipeline/splat/splats.h"
#include "pipeline/trace/surface_points.h"

namespace macula::hybrid {

// A splat for each point, in the same order: as wide as the matter around it reaches, as opaque as that is,
// with the light that leaves it. Of degree 0, linear radiance.
splat::Splats initialSplats(const trace::SurfacePoints& points);

// Axes of a covariance: the columns of `axes` are unit and right-handed, `variance` along each, largest
// first. By Jacobi's rotations; `symmetric` must be finite.
struct PrincipalAxes {
    glm::dmat3 axes{1.0};
    glm::dvec3 variance{0.0};
};
PrincipalAxes principalAxes(const glm::dmat3& symmetric);

}  // namespace macula::hybrid
