#include "evaluate/foveal_benchmark.h"

#include <algorithm>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>

#include "evaluate/measurement.h"
#include "image/metrics.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/reference_tracer.h"
#include "pipeline/trace/scene.h"

namespace macula::evaluate {

namespace {

Error cancelled() {
    return {ErrorCode::cancelled, Text("The benchmark was cancelled."), {}, {}};
}

enum class Sampling { even, adaptive };

struct Contender {
    trace::Denoising denoising = trace::Denoising::off;
    Sampling sampling = Sampling::even;
    trace::Indirect indirect = trace::Indirect::traced;
};

// The view, turned about its target and its up axis.
trace::View turned(trace::View view, double degrees) {
    Camera& camera = view.camera;
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(degrees), glm::normalize(camera.up));
    camera.positionMm =
        camera.targetMm + glm::dvec3(turn * glm::dvec4(camera.positionMm - camera.targetMm, 0.0));
    return view;
}

class Bench {
  public:
    Bench(const BenchStudy& study, const FovealOptions& options, Progress& progress)
        : study_(study), options_(options), progress_(progress) {}

    trace::Settings settings(trace::Denoising denoising, std::uint32_t seed) const {
        return {.bounces = options_.bounces, .seed = seed, .filter = options_.filter, .denoising = denoising};
    }

    // A tracer with compiled kernels and without any samples.
    Result<trace::PathTracer> warmTracer(const trace::Settings& settings) const {
        MACULA_TRY(trace::PathTracer tracer, study_.makeTracer());
        MACULA_TRY_VOID(tracer.setSettings(settings));
        tracer.setSideBySide(options_.sideBySide);
        MACULA_TRY([[maybe_unused]] const FovealTimes first, show(tracer, 1));
        MACULA_TRY_VOID(tracer.scene().setTransferFunction(study_.function));
        return tracer;
    }

    Result<void> trace(trace::PathTracer& tracer, std::uint32_t samples) const {
        MACULA_TRY(const bool whole, tracer.trace(samples, [&] { return !progress_.cancelled(); }));
        if (!whole || progress_.cancelled()) return cancelled();
        return {};
    }

    Result<void> traceMore(trace::PathTracer& tracer, Sampling sampling) const {
        if (sampling == Sampling::even) return trace(tracer, 1);
        // A CPU device traces for as long as a window waits for a picture. A graphics card makes many passes
        // in that time, and each may be enough, so it stops after one.
        const double portionMs = study_.device->isCpu() ? 100.0 : 0.0;
        MACULA_TRY(bool whole, tracer.traceFor(portionMs, [&] { return !progress_.cancelled(); }));
        while (!whole && portionMs == 0.0 && !progress_.cancelled()) {
            MACULA_TRY(whole, tracer.traceFor(portionMs));
        }
        return progress_.cancelled() ? Result<void>(cancelled()) : Result<void>();
    }

    Result<void> guides(trace::PathTracer& tracer) const {
        MACULA_TRY([[maybe_unused]] const trace::Guides* computed, tracer.guides());
        return study_.device->waitForAll();
    }

    Result<void> display(trace::PathTracer& tracer) const {
        MACULA_TRY([[maybe_unused]] const gpu::Image* picture, tracer.display(glm::vec3(0.0f)));
        return study_.device->waitForAll();
    }

    // Traces `samples` more, then guides if they are missing, then the displayed picture; waits after each.
    Result<FovealTimes> show(trace::PathTracer& tracer, std::uint32_t samples) const {
        FovealTimes times;
        MACULA_TRY(times.traceMs, timedMs([&] { return trace(tracer, samples); }));
        MACULA_TRY(times.guidesMs, timedMs([&] { return guides(tracer); }));
        MACULA_TRY(times.displayMs, timedMs([&] { return display(tracer); }));
        MACULA_TRY(const trace::Statistics statistics, tracer.statistics());
        times.dispatches = statistics.dispatches;
        return times;
    }

    Result<void> measureTimes(FovealReport& report) const {
        const TransferFunction function = fitted(study_.function, *study_.volume);
        const Medium medium =
            makeMedium(*study_.volume, makeBrickGrid(*study_.volume, reachOf(options_.filter)), function);
        const trace::ReferenceTracer reference(*study_.volume, medium, study_.environment);
        const trace::Settings all = settings(trace::Denoising::on, 1);
        MACULA_TRY(const shared::TraceParams params,
                   makeTraceParams(*study_.volume, medium, study_.environment, study_.view, all));
        MACULA_TRY(trace::PathTracer tracer, warmTracer(all));
        std::vector<FovealTimes> turns;
        for (int turn = 0; turn < options_.repetitions; ++turn) {
            MACULA_TRY_VOID(tracer.scene().setTransferFunction(study_.function));
            MACULA_TRY(FovealTimes times, show(tracer, options_.samples));
            MACULA_TRY(times.referenceTraceMs, timedMs([&]() -> Result<void> {
                           (void)reference.trace(params, all.filter, trace::Precision::single, 0,
                                                 options_.samples);
                           return {};
                       }));
            turns.push_back(times);
            progress_.advance();
        }
        const auto medianOf = [&](const std::function<double(const FovealTimes&)>& value) {
            std::vector<double> values;
            std::transform(turns.begin(), turns.end(), std::back_inserter(values), value);
            return median(std::move(values));
        };
        report.times = {.traceMs = medianOf([](const FovealTimes& t) { return t.traceMs; }),
                        .guidesMs = medianOf([](const FovealTimes& t) { return t.guidesMs; }),
                        .displayMs = medianOf([](const FovealTimes& t) { return t.displayMs; }),
                        .referenceTraceMs = medianOf([](const FovealTimes& t) { return t.referenceTraceMs; }),
                        .dispatches = medianOf([](const FovealTimes& t) { return t.dispatches; })};
        report.totalMs = medianOf([](const FovealTimes& t) { return t.totalMs(); });
        report.ratio = medianOf([](const FovealTimes& t) { return t.totalMs() / t.referenceTraceMs; });
        return {};
    }

    Result<image::Image> converge(FovealReport& report) const {
        MACULA_TRY(trace::PathTracer tracer, study_.makeTracer());
        MACULA_TRY_VOID(tracer.setSettings(settings(trace::Denoising::off, 12345)));
        const std::uint32_t first = options_.convergedSamples / 2;
        MACULA_TRY_VOID(traceInPortions(tracer, first));
        MACULA_TRY(const image::Image half, study_.readShown(tracer));
        MACULA_TRY_VOID(traceInPortions(tracer, options_.convergedSamples - first));
        MACULA_TRY(image::Image converged, study_.readShown(tracer));
        MACULA_TRY(const image::Flip left, image::flip(converged, half));
        report.convergedFlip = left.mean;
        return converged;
    }

    // Fills the cache as a hand does that turns the view to where it is.
    Result<void> lookAround(trace::PathTracer& tracer, trace::Settings own) const {
        constexpr int kPictures = 16;
        constexpr double kTurnDeg = 1.0;  // from one to the next
        for (int i = kPictures; i > 0; --i) {
            own.seed += 1;
            MACULA_TRY_VOID(tracer.setSettings(own));
            MACULA_TRY_VOID(tracer.setView(turned(study_.view, i * kTurnDeg)));
            MACULA_TRY_VOID(trace(tracer, 1));
        }
        own.seed += 1;
        MACULA_TRY_VOID(tracer.setSettings(own));
        MACULA_TRY_VOID(tracer.setView(study_.view));
        tracer.forgetViews();
        return {};
    }

    // Adds samples until the error is small enough. Counts only the time that a viewer would need: all
    // tracing, guides once, and the denoising and display of the last picture.
    Result<TimeToError> timeToError(const Contender& contender, const image::Image& converged) const {
        const bool isDenoised = contender.denoising == trace::Denoising::on;
        trace::Settings own = settings(contender.denoising, 1);
        own.indirect = contender.indirect;
        MACULA_TRY(trace::PathTracer tracer, warmTracer(own));
        if (own.indirect != trace::Indirect::traced) MACULA_TRY_VOID(lookAround(tracer, own));
        TimeToError result;
        double traceMs = 0.0;
        double guidesMs = 0.0;
        while (!result.reached && result.samples < options_.convergedSamples) {
            MACULA_TRY(const double ms, timedMs([&] { return traceMore(tracer, contender.sampling); }));
            traceMs += ms;
            if (isDenoised && guidesMs == 0.0) {
                MACULA_TRY(guidesMs, timedMs([&] { return guides(tracer); }));
            }
            MACULA_TRY(const double displayMs, timedMs([&] { return display(tracer); }));
            MACULA_TRY(const image::Image picture, study_.readShown(tracer));
            MACULA_TRY(const image::Flip flip, image::flip(converged, picture));
            MACULA_TRY(const trace::Statistics statistics, tracer.statistics());
            result.samples = statistics.meanSamplesPerPixel;
            result.ms = traceMs + guidesMs + displayMs;
            result.flip = flip.mean;
            result.reached = flip.mean <= options_.flip;
        }
        progress_.advance();
        return result;
    }

  private:
    Result<void> traceInPortions(trace::PathTracer& tracer, std::uint32_t samples) const {
        constexpr std::uint32_t kPortion = 16;
        for (std::uint32_t done = 0; done < samples; done += kPortion) {
            const std::uint32_t count = std::min(kPortion, samples - done);
            MACULA_TRY_VOID(trace(tracer, count));
            progress_.advance(count);
        }
        return {};
    }

    const BenchStudy& study_;
    const FovealOptions& options_;
    Progress& progress_;
};

}  // namespace

Result<FovealReport> measureFoveal(const BenchStudy& study, const FovealOptions& options,
                                   Progress& progress) {
    const Bench bench(study, options, progress);
    FovealReport report;
    progress.beginStage(Text("Measuring"), static_cast<std::size_t>(options.repetitions));
    MACULA_TRY_VOID(bench.measureTimes(report));
    if (options.convergedSamples == 0) return report;
    progress.beginStage(Text("Tracing the converged picture"), options.convergedSamples);
    MACULA_TRY(const image::Image converged, bench.converge(report));
    progress.beginStage(Text("Measuring the time to an error"), 7);
    using enum trace::Denoising;
    using enum trace::Indirect;
    MACULA_TRY(report.plain, bench.timeToError({off}, converged));
    MACULA_TRY(report.denoised, bench.timeToError({on}, converged));
    MACULA_TRY(report.adaptive, bench.timeToError({on, Sampling::adaptive}, converged));
    MACULA_TRY(report.cached, bench.timeToError({off, Sampling::even, cached}, converged));
    MACULA_TRY(report.cachedDenoised, bench.timeToError({on, Sampling::even, cached}, converged));
    MACULA_TRY(report.corrected, bench.timeToError({off, Sampling::even, corrected}, converged));
    MACULA_TRY(report.correctedDenoised, bench.timeToError({on, Sampling::even, corrected}, converged));
    return report;
}

}  // namespace macula::evaluate
