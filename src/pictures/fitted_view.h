// The camera of a picture for which nobody has given one: what can be seen fills it. The same for all verbs.
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

namespace macula::app {

struct FittedView {
    std::optional<ViewDirection> from = {};  // nothing: usualView
    double verticalFovDeg = 30.0;
    bool isParallel = false;
    double aspectWidthOverHeight = 1.0;
};

// `outlineMm` as of trace::PathTracer::outlineMm. Projections fit the whole volume, and so does what cannot
// be seen at all.
Camera fittedCamera(std::vector<glm::dvec3> outlineMm, trace::Look look, const Volume& volume,
                    const FittedView& view);

// What trace::PathTracer::outlineMm tells of the same scene, without a device. The volume is stored16, the
// function valid.
std::vector<glm::dvec3> outlineOnHostMm(const Volume& volume, const TransferFunction& function,
                                        const Clip& clip);

}  // namespace macula::app
