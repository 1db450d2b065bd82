// The camera for a picture without one: it fits what is visible. All commands share it.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"
#include "base/volume.h"
#include "pipeline/trace/look.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::pictures {

struct FittedView {
    std::optional<ViewDirection> from = {};  // nothing: usualView
    double verticalFovDeg = 30.0;
    bool isParallel = false;
    double aspectWidthOverHeight = 1.0;
};

// `outlineMm` as from trace::PathTracer::outlineMm. Fits the whole volume for projections, and if nothing is
// visible.
Camera fittedCamera(std::vector<glm::dvec3> outlineMm, trace::Look look, const Volume& volume,
                    const FittedView& view);

// The same outline as trace::PathTracer::outlineMm, without a device. The volume is stored16, the function
// valid.
std::vector<glm::dvec3> outlineOnHostMm(const Volume& volume, const TransferFunction& function,
                                        const Clip& clip);

}  // namespace macula::pictures
