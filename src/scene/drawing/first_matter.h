// What a person points at in a 3D picture, found in the volume itself and never in a model of it.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "base/camera.h"
#include "base/volume.h"
#include "scene/drawing/drawing.h"

namespace macula::app {

// The place in patient LPS mm where the ray from the eye, or of the parallel rays the one, through `place`
// (-1 to 1 in the picture, right and up are positive) meets the first matter that is shown: where half of the
// light is lost that is lost along the ray in all. Of projections the place of the largest or smallest value;
// of an average nothing. Nothing either where less than a fiftieth of the light is lost, and for a camera
// that is none. Walks in steps of a third of the smallest side of a voxel, at most 8192; in double precision,
// on the calling thread: up to some 20 ms, and where the preset is fitted to the volume as long as that
// takes.
std::optional<glm::dvec3> firstMatterMm(const Volume& volume, const Drawing& drawing, const Camera& camera,
                                        const glm::dvec2& place, double aspectWidthOverHeight);

}  // namespace macula::app
