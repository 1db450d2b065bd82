// Views that a model learns from: chosen, and given to its trainer.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/traced_view.h"
#include "pipeline/hybrid/traced_views.h"
#include "pipeline/hybrid/view_sampling.h"
#include "pipeline/splat/trainer.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

struct ChosenViews {
    std::vector<Camera> cameras;
    std::size_t givenUp = 0;  // none of the tries showed enough, and the last one was taken
};

// By sampleViews, asking `tracer` what a view shows (showsEnough). Fails as they do.
Result<ChosenViews> chooseViews(trace::PathTracer& tracer, const Box& seenMm, const ViewSampling& sampling,
                                const ViewLimits& limits, const Progress& progress);

// Takes part in the training from its next step on. Fails as Trainer::addView.
Result<void> learnFrom(splat::Trainer& trainer, const TracedView& view);

}  // namespace macula::hybrid
