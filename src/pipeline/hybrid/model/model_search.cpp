#include "pipeline/hybrid/model/model_search.h"

#include "base/camera.h"
#include "base/timeline.h"
#include "pipeline/hybrid/model/initial_splats.h"

namespace macula::hybrid {

void ModelSearch::forget() {
    seenMm_.reset();
    forgetStart();
}

void ModelSearch::forgetStart() {
    points_.reset();
    startWith_.reset();
}

// The search for points needs some view, though it finds what can be seen from anywhere.
Result<void> ModelSearch::findBox(trace::PathTracer& tracer) {
    MACULA_TRY_VOID(tracer.setView({.width = 64, .height = 64}));
    MACULA_TRY(const Box seen, tracer.seenMm());
    if (!(seen.diagonal() > 0.0) || glm::any(glm::greaterThan(seen.low, seen.high))) return {};
    MACULA_TRY_VOID(tracer.setView(
        {.camera = frameBox(seen, ViewDirection::anterior, 20.0, 1.0), .width = 64, .height = 64}));
    seenMm_ = seen;
    return {};
}

Result<ModelSearch::Found> ModelSearch::findSome(trace::PathTracer& tracer,
                                                 const trace::SurfacePointOptions& options,
                                                 const std::function<bool()>& goesOn) {
    if (!seenMm_) MACULA_TRY_VOID(findBox(tracer));
    if (!seenMm_) return Found::nothing;
    if (startWith_ || points_) return Found::all;
    const TimelineStage stage("model: points");
    MACULA_TRY(points_, tracer.someSurfacePoints(options, goesOn));
    if (!points_) return Found::notYet;
    if (points_->points.empty()) return Found::nothing;
    return goesOn() ? Found::all : Found::notYet;
}

ModelStart ModelSearch::start(const std::string& key) const {
    return {.splats = startWith_ ? *startWith_ : initialSplats(*points_),
            .seenMm = *seenMm_,
            .isTaught = startWith_ != nullptr && isOfThis_,
            .key = key};
}

}  // namespace macula::hybrid
