#include "evaluate/study_training_benchmark.h"

#include <span>
#include <utility>

#include "evaluate/measurement.h"
#include "pipeline/hybrid/model/initial_splats.h"
#include "pipeline/splat/draw/model_painter.h"

namespace macula::evaluate {

Result<StudyTrainingBench> StudyTrainingBench::create(const BenchStudy& study,
                                                      const StudyTrainingOptions& options,
                                                      Progress& progress) {
    MACULA_TRY(trace::PathTracer tracer, study.makeTracer());
    StudyTrainingBench bench(study, options, std::move(tracer), progress);
    progress.beginStage(Text("Finding points"), 1);
    MACULA_TRY_VOID(bench.findModel());
    return bench;
}

Result<void> StudyTrainingBench::findModel() {
    MACULA_TRY(const trace::SurfacePoints points,
               tracer_.surfacePoints({.count = options_.splats}, [&] { return !progress_.cancelled(); }));
    if (points.points.empty())
        return Error{ErrorCode::inputNotUsable,
                     Text("Nothing of the series can be seen."),
                     {},
                     Text("Choose another preset.")};
    model_ = hybrid::initialSplats(points);
    model_.setShDegree(options_.shDegree);
    return {};
}

Result<hybrid::TracedView> StudyTrainingBench::traceOne(const glm::ivec2& sizePx) {
    MACULA_TRY(auto traced,
               hybrid::traceViews(tracer_, std::span(&study_.view.camera, 1),
                                  {.sizePx = sizePx, .samplesPerPixel = kSamplesPerPixel}, progress_));
    return std::move(traced.views.front());
}

Result<SizedTrainingBenchmark> StudyTrainingBench::measure(const glm::ivec2& sizePx) {
    MACULA_TRY(hybrid::TracedView traced, traceOne(sizePx));
    MACULA_TRY(const splat::RasterView view, splat::rasterView(traced.camera, sizePx, model_.originMm));
    progress_.beginStage(Text("Measuring"), static_cast<std::size_t>(options_.repetitions));
    MACULA_TRY(TrainingBenchmark training,
               benchmarkTraining(study_.device, model_, {.view = view, .pixels = std::move(traced.rgba)},
                                 {.trainer = hybrid::trainerOptions({}), .repetitions = options_.repetitions},
                                 progress_));
    return SizedTrainingBenchmark{.sizePx = sizePx, .training = training};
}

Result<BeginningBenchmark> StudyTrainingBench::measureBeginning(const glm::ivec2& sizePx) {
    progress_.beginStage(Text("Measuring the beginning"), 1);
    MACULA_TRY(const splat::RasterView view, splat::rasterView(study_.view.camera, sizePx, model_.originMm));
    const auto firstPicture = [&]() -> Result<void> {
        MACULA_TRY_VOID(findModel());
        MACULA_TRY(auto painter, splat::ModelPainter::create(study_.device, model_));
        MACULA_TRY([[maybe_unused]] const auto picture, painter.draw(view));
        return {};
    };
    const auto tracing = [&]() -> Result<void> {
        MACULA_TRY([[maybe_unused]] const auto traced, traceOne(sizePx));
        return {};
    };
    BeginningBenchmark beginning;
    MACULA_TRY(beginning.firstSplatsMs, medianMs(options_.repetitions, [&] { return findModel(); }));
    MACULA_TRY(beginning.firstPictureMs, medianMs(options_.repetitions, firstPicture));
    MACULA_TRY(beginning.tracedViewMs, medianMs(options_.repetitions, tracing));
    return beginning;
}

}  // namespace macula::evaluate
