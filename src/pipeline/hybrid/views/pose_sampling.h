// The poses from which a volume is looked at when a peripheral model of it is trained and judged: the views
// of Kleinbeck et al. (IEEE VR 2026), which start far out and come nearer and wander further off the centre
// with each one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"

namespace macula::hybrid {

// Let C be the centre of what is seen, R its half-diagonal, and v the variability, which starts at 0 and
// grows by `increment` with each view up to `mostVariability`. A view looks
//   at   C + 0.8 R v b
//   from C + (startDistance - v) R s + 0.4 R v b'
// with s spread evenly over the sphere (scrambled Sobol points) and b, b' even in the unit ball. Negative
// radii are as good as others: the camera has crossed over.
//
// The numbers are the paper's; the draws are not those of its NumPy and SciPy, whose generators are not
// reproduced here.
struct PoseSampling {
    std::size_t count = 12;
    double startDistance = 5.5;  // of the first view, in R
    double increment = 0.04;
    double mostVariability = 1.7;
    std::uint64_t seed = 42;
    double verticalFovDeg = kTrainingFieldDeg;
    int mostTries = 200;  // for each view
};

// The poses that a first model is trained with; `trial` gives other views of the same kind.
PoseSampling initialTraining(std::size_t count, std::uint64_t trial = 0);
// The poses that it also learns from without their being traced: likewise distributed, but other draws.
PoseSampling otherSides(std::size_t count, std::uint64_t trial = 0);
// The poses at which it is compared with the ground truth.
PoseSampling groundTruth(std::size_t count = 32);
// The poses at which whole frames are compared: wider, and nearer (the paper's Table 3).
PoseSampling wholeFrames(std::size_t count = 32);
// The poses that it is refined with.
PoseSampling extension(std::size_t count);

struct SampledPose {
    Camera camera;
    int tries = 1;
    bool accepted = true;  // false: none of mostTries was, and this is the last one
};

// Up in the picture, for a unit direction of view: the patient's superior; anterior where the view is within
// a thousandth of that axis.
glm::dvec3 upFor(const glm::dvec3& forward);

// Whether a view shows enough, from far enough. What it is that is asked is up to the caller.
using PoseAcceptance = std::function<Result<bool>(const Camera& camera)>;

// A function of its arguments and of the answers of `accept` (may be empty: every view is taken). Each try
// takes the next point of the Sobol sequence. Fails with usage when the box is empty, a point, or not finite,
// or a number is not usable, and where `accept` fails.
Result<std::vector<SampledPose>> samplePoses(const Box& seenMm, const PoseSampling& sampling,
                                             const PoseAcceptance& accept = {});

}  // namespace macula::hybrid
