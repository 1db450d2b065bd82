// The camera poses with which a peripheral model of a volume is trained and judged: the views of Kleinbeck et
// al. (IEEE VR 2026), which start far away, and with each view come nearer and stray farther from the centre.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"

namespace macula::hybrid {

// Let C be the centre of the box of visible matter, R its half-diagonal, and v the variability, which starts
// at 0 and grows by `increment` with each view up to `mostVariability`. A view looks
//   at   C + 0.8 R v b
//   from C + (startDistance - v) R s + 0.4 R v b'
// with s spread evenly over the sphere (scrambled Sobol points) and b, b' uniform in the unit ball. The
// radius may become negative: then the camera is on the other side.
//
// The numbers are the paper's; the random draws are not, because the generators of NumPy and SciPy are not
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
// The poses of its views that are not traced: with the same distribution, but other draws.
PoseSampling otherSides(std::size_t count, std::uint64_t trial = 0);
// The poses at which a model is compared with the ground truth.
PoseSampling groundTruth(std::size_t count = 32);
// The poses at which whole frames are compared: with a wider field, and nearer (the paper's Table 3).
PoseSampling wholeFrames(std::size_t count = 32);
// The poses that a model is refined with.
PoseSampling extension(std::size_t count);

struct SampledPose {
    Camera camera;
    int tries = 1;
    bool accepted = true;  // false: all mostTries failed, and this is the last one
};

// The up direction of a picture, for a unit direction of view: the patient's superior; anterior if the view
// is within a thousandth of that axis.
glm::dvec3 upFor(const glm::dvec3& forward);

// Whether a view shows enough, from far enough away; the caller decides how to find out.
using PoseAcceptance = std::function<Result<bool>(const Camera& camera)>;

// The result depends only on the arguments and on the answers of `accept` (if empty, every view is accepted).
// Each try uses the next point of the Sobol sequence. Fails with usage if the box is empty, a point or not
// finite, or a number is unusable, and if `accept` fails.
Result<std::vector<SampledPose>> samplePoses(const Box& seenMm, const PoseSampling& sampling,
                                             const PoseAcceptance& accept = {});

// Points that fill a square more evenly than random ones: point `index` of the first two dimensions of the
// Sobol sequence (Sobol 1967), with nested uniform scrambling (Owen 1995): over the seeds each point is
// uniform in [0, 1)^2, and the points of one seed are as well spread as the sequence. Of any 2^k points from
// a multiple of 2^k on, one lies in each elementary interval of area 2^-k.
glm::dvec2 scrambledSobol(std::uint32_t index, std::uint64_t seed);

}  // namespace macula::hybrid
