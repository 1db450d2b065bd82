#include "pipeline/hybrid/learnt_views.h"

namespace macula::hybrid {

Result<ChosenViews> chooseViews(trace::PathTracer& tracer, const Box& seenMm, const ViewSampling& sampling,
                                const ViewLimits& limits, const Progress& progress) {
    const double radiusMm = 0.5 * seenMm.diagonal();
    MACULA_TRY(const auto views,
               sampleViews(seenMm, sampling, showsEnough(tracer, radiusMm, limits, progress)));
    ChosenViews chosen;
    for (const SampledView& view : views) {
        chosen.cameras.push_back(view.camera);
        if (!view.accepted) ++chosen.givenUp;
    }
    return chosen;
}

Result<void> learnFrom(splat::Trainer& trainer, const TracedView& view) {
    const glm::dvec3 originMm = trainer.lastGood().splats.originMm;
    MACULA_TRY(const splat::RasterView from, splat::rasterView(view.camera, view.sizePx, originMm));
    return trainer.addView({.view = from, .pixels = view.rgba});
}

}  // namespace macula::hybrid
