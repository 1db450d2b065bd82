#include "evaluate/trace_benchmark.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "pipeline/trace/reference_tracer.h"
#include "pipeline/trace/scene.h"

namespace macula::evaluate {

namespace {

struct Spent {
    double wallMs = 0.0;
    double cpuMs = 0.0;
};

// std::clock is the processor time of all threads of the process.
template <class Work>
Spent timed(const Work& work) {
    const auto wall = std::chrono::steady_clock::now();
    const std::clock_t cpu = std::clock();
    work();
    return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - wall).count(),
            1000.0 * double(std::clock() - cpu) / CLOCKS_PER_SEC};
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

TraceBenchmark::Contender contender(const std::vector<Spent>& turns, const TraceBenchmarkOptions& options) {
    std::vector<double> wall;
    std::vector<double> cpu;
    for (const Spent& turn : turns) {
        wall.push_back(turn.wallMs / options.samplesPerPixel);
        cpu.push_back(turn.cpuMs / options.samplesPerPixel);
    }
    const double pixels = double(options.view.width) * options.view.height;
    return {.secondsPerSample = median(wall) / 1e3,
            .cpuSecondsPerSample = median(cpu) / 1e3,
            .microsecondsPerPixel = median(wall) / pixels * 1e3};
}

}  // namespace

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

        std::vector<Spent> deviceTurns;
        std::vector<Spent> referenceTurns;
        std::vector<double> wallRatios;
        std::vector<double> cpuRatios;
        for (int turn = 0; turn < options.repetitions; ++turn) {
            if (progress.cancelled())
                return Error{ErrorCode::cancelled, "The benchmark was cancelled.", {}, {}};
            MACULA_TRY_VOID(tracer.setSettings(settings));  // from the first sample again
            Result<bool> traced = true;
            deviceTurns.push_back(timed([&] { traced = tracer.trace(options.samplesPerPixel); }));
            if (!traced) return traced.error();
            referenceTurns.push_back(timed([&] {
                (void)reference.trace(params, filter, trace::Precision::single, 0, options.samplesPerPixel);
            }));
            wallRatios.push_back(deviceTurns.back().wallMs / referenceTurns.back().wallMs);
            cpuRatios.push_back(deviceTurns.back().cpuMs / referenceTurns.back().cpuMs);
            progress.advance();
        }
        reports.push_back({.filter = filter,
                           .device = contender(deviceTurns, options),
                           .reference = contender(referenceTurns, options),
                           .wallRatio = median(wallRatios),
                           .cpuRatio = median(cpuRatios)});
    }
    return reports;
}

}  // namespace macula::evaluate
