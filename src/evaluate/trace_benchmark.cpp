#include "evaluate/trace_benchmark.h"

#include <iterator>

#include "pipeline/trace/reference_tracer.h"
#include "pipeline/trace/scene.h"

namespace macula::evaluate {

Result<std::vector<TraceBenchmark>> benchmarkTracing(const std::shared_ptr<gpu::Device>& device,
                                                     const std::shared_ptr<const Volume>& volume,
                                                     const TransferFunction& function,
                                                     const trace::Environment& environment,
                                                     const TraceBenchmarkOptions& options,
                                                     Progress& progress) {
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device));
    MACULA_TRY_VOID(tracer.setVolume(volume));
    MACULA_TRY_VOID(tracer.setTransferFunction(function));
    MACULA_TRY_VOID(tracer.setEnvironment(environment));
    MACULA_TRY_VOID(tracer.setView(options.view));
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), fitted(function, *volume));
    const trace::ReferenceTracer reference(*volume, medium, environment);
    MACULA_TRY(const shared::TraceParams params,
               trace::makeTraceParams(*volume, medium, environment, options.view, options.settings));

    constexpr trace::Filter kFilters[] = {trace::Filter::trilinear, trace::Filter::stochastic};
    progress.beginStage("Measuring", std::size(kFilters) * static_cast<std::size_t>(options.repetitions + 1));
    std::vector<TraceBenchmark> reports;
    for (const trace::Filter filter : kFilters) {
        trace::Settings settings = options.settings;
        settings.filter = filter;
        MACULA_TRY_VOID(tracer.setSettings(settings));
        MACULA_TRY([[maybe_unused]] const bool warm, tracer.trace(2));
        progress.advance();

        Contender ours;
        Contender scalar;
        for (int turn = 0; turn < options.repetitions; ++turn) {
            if (progress.cancelled())
                return Error{ErrorCode::cancelled, "The benchmark was cancelled.", {}, {}};
            MACULA_TRY_VOID(tracer.setSettings(settings));  // from the first sample again
            MACULA_TRY(const Spent traced, timed([&]() -> Result<void> {
                           MACULA_TRY([[maybe_unused]] const bool all, tracer.trace(options.samplesPerPixel));
                           return {};
                       }));
            MACULA_TRY(const Spent compared, timed([&]() -> Result<void> {
                           (void)reference.trace(params, filter, trace::Precision::single, 0,
                                                 options.samplesPerPixel);
                           return {};
                       }));
            ours.turns.push_back(traced / options.samplesPerPixel);
            scalar.turns.push_back(compared / options.samplesPerPixel);
            progress.advance();
        }
        reports.push_back({.filter = filter,
                           .device = ours.medians(),
                           .reference = scalar.medians(),
                           .ratio = ours.ratioTo(scalar)});
    }
    return reports;
}

}  // namespace macula::evaluate
