// Turns what a person sets (camera, lights, settings) into the numbers that the kernels read.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/medium.h"
#include "shared/trace_params.h"

namespace macula::trace {

// Positions are computed in double and relative to the volume, so a patient far from the scanner's origin
// costs no precision. Fails with usage when the camera, the size of the picture or a setting is not usable.
Result<shared::TraceParams> makeTraceParams(const Volume& volume, const Medium& medium,
                                            const Environment& environment, const View& view,
                                            const Settings& settings, const Clip& clip = {},
                                            const Additions& additions = {});

// How a usable view maps directions to positions in its stored picture, for shaders/lib/fovea.glsl.
struct FoveaInPlane {
    glm::dvec2 halfSize{1.0};  // of the picture, at distance 1
    glm::dvec2 gaze{0.0};
    double radius = 0.0;
    double magnification = 1.0;
    // For a parallel view: the distance at which an eye with this field of view would see as much; 0
    // otherwise.
    double parallelMm = 0.0;
};
FoveaInPlane foveaInPlane(const View& view);

// Only every n-th pixel along each side of a picture records indirect light for the cache (indirect_cache.h):
// returns n.
int indirectStride(int width, int height);

}  // namespace macula::trace
