// The poses from which a new picture would teach a model most.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/splat/draw/raster_view.h"
#include "pipeline/splat/model/splats.h"

namespace macula::hybrid {

// A view that a model has, or will have soon.
struct KnownPose {
    splat::RasterView view;  // relative to the model's origin
    // The model's mean difference in this view, divided by the mean coverage of the picture. 0 or below:
    // unknown.
    double error = 0.0;
};

struct CandidateOptions {
    glm::ivec2 sizePx{kTrainingSizePx};
    double verticalFovDeg = kTrainingFieldDeg;
    std::size_t candidates = 128;
    // The expected error grows by the known error itself for each newAngleDeg between the candidate and the
    // nearest view of the same target, and each time a pixel shows half as much.
    double newAngleDeg = 15.0;
    AdmissionOptions admission = {};  // views of the same pose (isSamePose) are not wanted
};

struct CandidatePose {
    Camera camera;
    double expectedError = 0.0;  // in units of KnownPose::error, which counts as 1 if all are unknown
};

// Draws candidates as samplePoses does, from far away if few views are known, and nearer with more. A known
// view sees a candidate's target if this lies in its picture; the newness of a candidate is the angle at its
// target to the nearest of these views. Its expected error is the mean of the known errors, weighted towards
// similar views, and grows with newness. Sorted by largest expected error; leaves out known poses. The result
// depends only on the arguments. Fails as samplePoses does.
Result<std::vector<CandidatePose>> candidatePoses(std::span<const KnownPose> known, const Box& seenMm,
                                                  const glm::dvec3& originMm, std::uint64_t seed,
                                                  const CandidateOptions& options = {});

// A pose that shows something among those that would teach a model most: the first of `wanted` in which the
// model covers enough of the picture, or else the one in which it covers most; nothing if all are empty.
// Draws small pictures in the shape of `sizePx`, usually one. Fails as drawViews does.
Result<std::optional<CandidatePose>> firstThatShows(const std::shared_ptr<gpu::Device>& device,
                                                    const splat::Splats& model,
                                                    std::span<const CandidatePose> wanted,
                                                    const glm::ivec2& sizePx);

}  // namespace macula::hybrid
