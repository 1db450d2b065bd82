// The first peripheral model: splats from points on the surface, before any training. It is what a person
// sees first, and what the trainer starts from.
#pragma once

#include "pipeline/splat/model/splats.h"
#include "pipeline/trace/surface_points.h"

namespace macula::hybrid {

// Where the error of the first picture is least over phantom, chest CT (bone, soft tissue) and CTA (vessels),
// each from four sides, see docs/peripheral-model.md.
struct InitialSplatOptions {
    // Of the standard deviation over that of the matter around: neighbours overlap so that there is no gap,
    // and no more.
    double width = 1.1;
    // A splat lies so far from its point towards the middle of the matter, so that its outer half does
    // not stand out of the surface.
    double inwards = 1.1;
    // Splats stand for what is seen only; they have to hide what nobody sees behind them, too: so many times
    // denser they are.
    double denser = 6.0;
    // No splat is thinner than this part of the distance to its neighbours: as an edge of a voxel is soft.
    double thinnest = 0.15;
};

// A splat for each point, in the same order: as wide as the matter around it reaches, as opaque as that is,
// with the light that leaves it. Of degree 0, linear radiance. Valid for any points of finite numbers.
splat::Splats initialSplats(const trace::SurfacePoints& points, const InitialSplatOptions& options = {});

// Axes of a covariance: the columns of `axes` are unit and right-handed, `variance` along each, largest
// first. By Jacobi's rotations; `symmetric` must be finite.
struct PrincipalAxes {
    glm::dmat3 axes{1.0};
    glm::dvec3 variance{0.0};
};
PrincipalAxes principalAxes(const glm::dmat3& symmetric);

}  // namespace macula::hybrid
