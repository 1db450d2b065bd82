// The point that a user points at in a 3D picture, found in the volume itself and never in a model of it.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "base/camera.h"
#include "base/volume.h"
#include "scene/drawing/drawing.h"

namespace macula::scene {

// The point in patient LPS mm where the ray through `place` (-1 to 1 in the picture, right and up positive)
// meets the first shown matter: where the ray has lost half of the light that it loses in all, or where it
// enters a grey face of the clip. For MIP and MinIP the point of the largest or smallest value. Nothing for
// an average, where the ray loses less than a fiftieth of the light, and for an invalid camera. Steps are a
// third of the smallest side of a voxel, or longer so that 8192 suffice. In double precision, on the calling
// thread: up to some 20 ms, plus the time of the fit if the preset is fitted to the volume.
std::optional<glm::dvec3> firstMatterMm(const Volume& volume, const Drawing& drawing, const Camera& camera,
                                        const glm::dvec2& place, double aspectWidthOverHeight);

}  // namespace macula::scene
