// Chooses the views that a model learns from, and gives them to its trainer.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/camera.h"
#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/views/pose_sampling.h"
#include "pipeline/hybrid/views/view_tracing.h"
#include "pipeline/splat/draw/raster_view.h"
#include "pipeline/splat/train/trainer.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

struct ChosenPoses {
    std::vector<Camera> cameras;
    std::size_t givenUp = 0;  // no try showed enough, and the last one was used
};

// Chooses by samplePoses, where `tracer` finds out what a view shows (showsEnough). Fails as these do.
Result<ChosenPoses> choosePoses(trace::PathTracer& tracer, const Box& seenMm, const PoseSampling& sampling,
                                const PoseLimits& limits, const Progress& progress);

// The weight in training of a picture by its samples per pixel: nearly proportional to few samples, 1 at 8,
// and below 2 for any number, because the denoiser's blur remains.
float weightBySamples(double samplesPerPixel);

// The weight in training of a picture by its distance: the area that it spans at the centre of `seenMm`, over
// that of the first view of groundTruth (square, kTrainingFieldDeg, from 3 R, R being half the diagonal); at
// most 4, and from nearer than R / 2 as from there. The gradient of a splat grows with its size in the
// picture, and Adam scales its steps by the largest gradients: without this weight, near views would drown
// far ones (docs/peripheral-model.md). 1 if the box has no finite extent. `from` is relative to `originMm`,
// that of the model, which is in world mm, as is the box.
float weightByArea(const splat::RasterView& from, const Box& seenMm, const glm::dvec3& originMm);

// The view in the form that a trainer learns, with its weight: by area, and by samples unless it is lit. All
// views of a trainer need nearly the same `seenMm`. Fails with usage as rasterView does, and for parallel
// cameras.
Result<splat::TrainingView> trainingView(const splat::Trainer& trainer, const Box& seenMm, TracedView view);
// The same for a view of coverageViews: it has no noise, so its weight is by area alone.
Result<splat::TrainingView> coverageTrainingView(const splat::Trainer& trainer, const Box& seenMm,
                                                 TracedView view);

// Adds a view to the training from the next step on. Fails as Trainer::addView does.
Result<void> learnFrom(splat::Trainer& trainer, const Box& seenMm, TracedView view);
// Adds a lit view as a stand-in, which takes part while there are few pictures (ViewKind).
Result<void> learnStandInFrom(splat::Trainer& trainer, const Box& seenMm, TracedView view);
Result<void> learnCoverageFrom(splat::Trainer& trainer, const Box& seenMm, TracedView view);

// The limits by which a view counts as new for a model.
struct AdmissionOptions {
    // A pose is new if its eye is farther than this from all earlier ones, in half-diagonals of the box of
    // visible matter, or if its direction differs by more than newAngleDeg.
    double newDistanceRadii = 0.05;
    double newAngleDeg = 5.0;
    // A picture with a known pose is new if the model's mean difference to it is more than so many times the
    // largest one to its earlier pictures with that pose.
    double newDifference = 1.5;
};
enum class Novelty { none, pose, picture };

// Whether both views have nearly the same eye and direction. Ignores roll and field of view.
bool isSamePose(const splat::RasterView& a, const splat::RasterView& b, double radiusMm,
                const AdmissionOptions& options = {});

// Calls Trainer::addView if the picture is new, and returns in which way. A picture is not new while the
// trainer has a view with that pose that it has not drawn yet. Fails as Trainer::addView does.
Result<Novelty> admit(splat::Trainer& trainer, splat::TrainingView picture, double radiusMm,
                      const AdmissionOptions& options = {});

// Views that a model has asked for, and that have not arrived yet.
class AskedViews {
  public:
    explicit AskedViews(const glm::ivec2& sizePx) : sizePx_(sizePx) {}

    // Keeps the last few.
    void add(const Camera& camera);
    // Call when a picture has arrived from `from`: forgets views of the same pose.
    void came(const splat::RasterView& from, const glm::dvec3& originMm, double radiusMm,
              const AdmissionOptions& options);
    // The views, with pictures of `sizePx`, relative to the origin of a model.
    std::vector<splat::RasterView> views(const glm::dvec3& originMm) const;

  private:
    glm::ivec2 sizePx_;
    std::vector<Camera> cameras_;
};

// An upper estimate of the device memory that the views of a trainer take.
double bytesOfViews(const splat::Trainer& trainer);
// Mean number of pixels of a view; 0 without views.
double meanPixelsOfViews(const splat::Trainer& trainer);

// The index of the picture with exactly this view, if any.
std::optional<std::size_t> pictureOf(const splat::Trainer& trainer, const splat::RasterView& view);
// Whether there is a picture from there (isSamePose).
bool hasPictureFrom(const splat::Trainer& trainer, const splat::RasterView& view, double radiusMm,
                    const AdmissionOptions& options);

}  // namespace macula::hybrid
