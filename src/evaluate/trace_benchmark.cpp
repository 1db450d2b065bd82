#include "evaluate/trace_benchmark.h"

#include "pictures/drawn_picture.h"
#include "pipeline/trace/reference_tracer.h"
#include "pipeline/trace/scene.h"

namespace macula::evaluate {

namespace {

// The contenders on the device, for one picture and one filter.
class Turns {
  public:
    static Result<Turns> begin(const BenchStudy& study, const TraceBenchmarkOptions& options,
                               trace::Filter filter, Progress& progress) {
        const trace::Settings settings{.bounces = options.bounces, .filter = filter};
        MACULA_TRY(trace::PathTracer tracer, study.makeTracer());
        MACULA_TRY_VOID(tracer.setSettings(settings));
        const pictures::PictureRequest request{.scene = {.volume = study.volume,
                                                         .function = study.function,
                                                         .clip = {},
                                                         .environment = study.environment},
                                               .camera = study.view.camera,
                                               .sizePx = {study.view.width, study.view.height},
                                               .settings = settings,
                                               .samplesPerPixel = options.samplesPerPixel};
        MACULA_TRY(pictures::PictureDrawer drawer,
                   pictures::PictureDrawer::create(study.device, request, progress));
        Turns turns(study, options.samplesPerPixel, settings, std::move(tracer), std::move(drawer));
        MACULA_TRY([[maybe_unused]] const Spent traced, turns.trace());
        MACULA_TRY([[maybe_unused]] const Spent drawn, turns.draw());
        return turns;
    }

    Result<Spent> trace() {
        MACULA_TRY_VOID(tracer_.setSettings(settings_));  // restarts from the first sample
        return timed([&]() -> Result<void> {
            MACULA_TRY([[maybe_unused]] const bool all, tracer_.trace(samples_));
            return {};
        });
    }
    Result<Spent> draw() {
        Progress nobody;
        return timed([&]() -> Result<void> {
            MACULA_TRY([[maybe_unused]] const pictures::DrawnPicture drawn,
                       drawer_.draw(study_.view.camera, nobody));
            return {};
        });
    }

  private:
    Turns(const BenchStudy& study, std::uint32_t samples, const trace::Settings& settings,
          trace::PathTracer tracer, pictures::PictureDrawer drawer)
        : study_(study),
          samples_(samples),
          settings_(settings),
          tracer_(std::move(tracer)),
          drawer_(std::move(drawer)) {}

    const BenchStudy& study_;
    std::uint32_t samples_;
    trace::Settings settings_;
    trace::PathTracer tracer_;
    pictures::PictureDrawer drawer_;
};

}  // namespace

Result<std::vector<TraceBenchmark>> benchmarkTracing(const BenchStudy& study,
                                                     const TraceBenchmarkOptions& options,
                                                     Progress& progress) {
    std::vector<trace::Filter> filters{trace::Filter::trilinear, trace::Filter::stochastic};
    if (options.filter) filters = {*options.filter};
    progress.beginStage(Text("Measuring"),
                        filters.size() * static_cast<std::size_t>(options.repetitions + 1));
    std::vector<TraceBenchmark> reports;
    for (const trace::Filter filter : filters) {
        const Medium medium = makeMedium(*study.volume, makeBrickGrid(*study.volume, trace::reachOf(filter)),
                                         fitted(study.function, *study.volume));
        const trace::ReferenceTracer reference(*study.volume, medium, study.environment);
        MACULA_TRY(const shared::TraceParams params,
                   trace::makeTraceParams(*study.volume, medium, study.environment, study.view,
                                          {.bounces = options.bounces}));
        MACULA_TRY(Turns turns, Turns::begin(study, options, filter, progress));
        progress.advance();

        Contender ours;
        Contender calls;
        Contender scalar;
        for (int turn = 0; turn < options.repetitions; ++turn) {
            if (progress.cancelled()) return cancelledError();
            MACULA_TRY(const Spent traced, turns.trace());
            MACULA_TRY(const Spent drawn, turns.draw());
            MACULA_TRY(const Spent compared, timed([&]() -> Result<void> {
                           (void)reference.trace(params, filter, trace::Precision::single, 0,
                                                 options.samplesPerPixel);
                           return {};
                       }));
            ours.turns.push_back(traced / options.samplesPerPixel);
            calls.turns.push_back(drawn / options.samplesPerPixel);
            scalar.turns.push_back(compared / options.samplesPerPixel);
            progress.advance();
        }
        reports.push_back({.filter = filter,
                           .device = ours.medians(),
                           .call = calls.medians(),
                           .reference = scalar.medians(),
                           .ratio = ours.ratioTo(scalar),
                           .calls = calls.ratioTo(ours)});
    }
    return reports;
}

}  // namespace macula::evaluate
