// Views that a model learns from: chosen, and given to its trainer.
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/views/pose_sampling.h"
#include "pipeline/hybrid/views/view_tracing.h"
#include "pipeline/splat/train/trainer.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

struct ChosenPoses {
    std::vector<Camera> cameras;
    std::size_t givenUp = 0;  // none of the tries showed enough, and the last one was taken
};

// Chooses by samplePoses, asking `tracer` what a view shows (showsEnough). Fails as they do.
Result<ChosenPoses> choosePoses(trace::PathTracer& tracer, const Box& seenMm, const PoseSampling& sampling,
                                const PoseLimits& limits, const Progress& progress);

// The weight in training of a picture by its samples: 1 at 8, as many as the pictures have that a model
// begins with; in proportion to them where there are few, at most 2, because what the denoiser blurs stays.
float weightBySamples(double samplesPerPixel);

// The weight in training of a picture by its distance: the area that it spans where the centre of `seenMm`
// is, over that of the first view that models are compared in (groundTruth: kTrainingFieldDeg, square, from 3
// R, R being half the diagonal); at most 4, and from nearer than R / 2 as from there. A picture pulls at a
// splat as hard as the splat is large in it, and Adam goes by what pulled hardest: without this, what was
// seen from near would drown what was seen from far (docs/peripheral-model.md). 1 where the box has no
// extent, or none that is finite. `from` is relative to `originMm`, the model's; that and the box are in
// world mm.
float weightByArea(const splat::RasterView& from, const Box& seenMm, const glm::dvec3& originMm);

// The view as a trainer learns it, with its weight: by area, and by samples unless it is lit. Of views of one
// trainer `seenMm` is the same, or nearly. usage as rasterView.
Result<splat::TrainingView> trainingView(const splat::Trainer& trainer, const Box& seenMm, TracedView view);
// The same of the coverage alone, which coverageViews finds: without chance, so its weight is by area alone.
Result<splat::TrainingView> coverageTrainingView(const splat::Trainer& trainer, const Box& seenMm,
                                                 TracedView view);

// Adds a view to the training from its next step on. Fails as Trainer::addView.
Result<void> learnFrom(splat::Trainer& trainer, const Box& seenMm, TracedView view);
// Adds a litView, which takes part as long as there are few pictures.
Result<void> learnStandInFrom(splat::Trainer& trainer, const Box& seenMm, TracedView view);
Result<void> learnCoverageFrom(splat::Trainer& trainer, const Box& seenMm, TracedView view);

// The limits by which a view counts as new for a model.
struct AdmissionOptions {
    // Seen from somewhere else than any view before: farther away than that, in half-diagonals of what is
    // seen, or in another direction.
    double newDistanceRadii = 0.05;
    double newAngleDeg = 5.0;
    // Or the model is worse there: mean difference, over the most of any picture it has from there.
    double newDifference = 1.5;
};
enum class Novelty { none, pose, picture };

// Whether both are seen from the same place in the same direction, or nearly. Roll and field of view are not
// looked at.
bool isSamePose(const splat::RasterView& a, const splat::RasterView& b, double radiusMm,
                const AdmissionOptions& options = {});

// Trainer::addView, if it shows something new; what that is. While the trainer has a view from there that it
// has not come to yet, another picture is not new. Fails as Trainer::addView.
Result<Novelty> admit(splat::Trainer& trainer, splat::TrainingView picture, double radiusMm,
                      const AdmissionOptions& options = {});

}  // namespace macula::hybrid
