// The first peripheral model: splats from points on the surface, before any training. It is what a person
// sees first, and what the trainer starts from.
#pragma once

#include "pipeline/splat/model/splats.h"
#include "pipeline/trace/surface_points.h"

namespace macula::hybrid {

// The defaults minimise the error of the first picture over phantom, chest CT (bone, soft tissue) and CTA
// (vessels), each from four sides: docs/peripheral-model.md.
struct InitialSplatOptions {
    // The standard deviation of a splat over that of the matter around it: neighbours overlap just enough to
    // leave no gap.
    double width = 1.1;
    // How far a splat is moved from its point towards the centre of the matter, as a part of that distance,
    // so that its outer half does not stick out of the surface.
    double inwards = 1.1;
    // How many times denser splats are than the matter: they represent only the surface, but must also hide
    // what lies behind it.
    double denser = 6.0;
    // No splat is thinner than this part of a point's radius, because edges between voxels are soft.
    double thinnest = 0.15;
};

// A splat for each point, in the same order: as wide and as opaque as the matter around it, with the light
// that leaves it. Degree 0, linear radiance. Valid for any points of finite numbers.
splat::Splats initialSplats(const trace::SurfacePoints& points, const InitialSplatOptions& options = {});

// Axes of a covariance: the columns of `axes` are unit vectors and right-handed, with `variance` along each,
// largest first. principalAxes uses Jacobi rotations; `symmetric` must be finite.
struct PrincipalAxes {
    glm::dmat3 axes{1.0};
    glm::dvec3 variance{0.0};
};
PrincipalAxes principalAxes(const glm::dmat3& symmetric);

}  // namespace macula::hybrid
