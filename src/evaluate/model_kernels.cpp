#include "evaluate/model_kernels.h"

#include "pipeline/hybrid/model/first_model.h"

namespace macula::evaluate {

Result<void> compileModelKernels(const BenchStudy& study, live::SceneOnDevice& scene, int bounces,
                                 Progress& progress) {
    hybrid::FirstModelOptions least{.views = 1, .samplesPerPixel = 1, .directions = 2, .sizePx = 32};
    least.points.count = 256;
    least.bounces = bounces;
    least.iterations = 10;
    MACULA_TRY([[maybe_unused]] const hybrid::FirstModel model,
               hybrid::makeFirstModel(study.device, scene.tracer, scene.traced.seenMm(), least, progress));
    return {};
}

}  // namespace macula::evaluate
