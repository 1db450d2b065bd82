// The poses from which a new picture would teach a model most.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/splat/draw/raster_view.h"

namespace macula::hybrid {

// A view that a model has, or will have soon.
struct KnownPose {
    splat::RasterView view;  // relative to the model's origin
    // The model's mean difference in this view, over the part of the picture that shows anything. 0 or below:
    // not known.
    double error = 0.0;
};

struct CandidateOptions {
    glm::ivec2 sizePx{kTrainingSizePx};
    double verticalFovDeg = kTrainingFieldDeg;
    std::size_t candidates = 128;
    // The error is taken to grow by as much again with every so many degrees from the nearest view that sees
    // the same, and with every halving of what a pixel shows.
    double newAngleDeg = 15.0;
    AdmissionOptions admission = {};  // views of the same pose (isSamePose) are not wanted
};

struct CandidatePose {
    Camera camera;
    double expectedError = 0.0;  // in units of KnownPose::error; 1 for an error not known from anywhere
};

// Candidates are views as samplePoses draws them, from far out while few are known and nearer with more. A
// view's target counts as seen by those that have it in their picture; how new a candidate is is the angle at
// its target to the nearest of these. The error there is the mean over the known ones, those that are least
// new to it counting most, and grows with newness. Largest expected error first; none has a known pose. A
// function of its arguments. Fails as samplePoses.
Result<std::vector<CandidatePose>> candidatePoses(std::span<const KnownPose> known, const Box& seenMm,
                                                  const glm::dvec3& originMm, std::uint64_t seed,
                                                  const CandidateOptions& options = {});

}  // namespace macula::hybrid
