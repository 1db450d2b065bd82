#include "evaluate/tradeoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "evaluate/measurement.h"
#include "image/masked_metrics.h"
#include "image/metrics.h"
#include "pipeline/trace/device_scene.h"

namespace macula::evaluate {

namespace {

class Bench {
  public:
    Bench(const BenchStudy& study, const TradeoffOptions& options) : study_(study), options_(options) {}

    Result<void> converge(Tradeoff& result, image::Mask& mask, Progress& progress) const {
        const trace::Settings settings{.bounces = options_.convergedBounces,
                                       .seed = 12345,
                                       .filter = trace::Filter::trilinear,
                                       .exposure = options_.exposure};
        MACULA_TRY(trace::PathTracer truth, study_.makeTracer());
        MACULA_TRY_VOID(truth.setSettings(settings));
        Watch watch;
        image::Image half;
        constexpr std::uint32_t kPortion = 16;
        for (std::uint32_t done = 0; done < options_.convergedSamples;) {
            const std::uint32_t count = std::min(kPortion, options_.convergedSamples - done);
            MACULA_TRY(const bool whole, truth.trace(count, [&] { return !progress.cancelled(); }));
            if (!whole || progress.cancelled())
                return Error{ErrorCode::cancelled, Text("The benchmark was cancelled."), {}, {}};
            const bool passesHalf =
                done < options_.convergedSamples / 2 && done + count >= options_.convergedSamples / 2;
            done += count;
            if (passesHalf) {
                MACULA_TRY(half, study_.readShown(truth));
            }
            progress.advance(count);
        }
        result.convergedMs = watch.lap().wallMs;
        MACULA_TRY(result.converged, study_.readShown(truth));
        MACULA_TRY(const image::Flip left, image::flip(result.converged, half));
        result.convergedFlip = left.mean;
        MACULA_TRY(const trace::TracedImage traced, truth.readback());
        for (const glm::vec4& pixel : traced.radiance) mask.push_back(pixel.a > 0.0f ? 1 : 0);
        MACULA_TRY(const trace::Statistics statistics, truth.statistics());
        result.convergedLost = statistics.nonFiniteSamples + statistics.abandonedSamples;
        return {};
    }

    Result<void> run(trace::Filter filter, trace::Denoising denoising, int bounces, const image::Mask& mask,
                     Tradeoff& result, Progress& progress) const {
        const trace::Settings settings{.bounces = bounces,
                                       .seed = 1,
                                       .filter = filter,
                                       .exposure = options_.exposure,
                                       .denoising = denoising};
        // A new tracer for each run, so that no samples of an earlier run are reused. A first picture
        // compiles kernels, which a program does only once, and is then discarded.
        MACULA_TRY(trace::PathTracer tracer, study_.makeTracer());
        MACULA_TRY_VOID(tracer.setSettings(settings));
        MACULA_TRY([[maybe_unused]] const bool warm, tracer.trace(1));
        MACULA_TRY([[maybe_unused]] const image::Image ignored, study_.readShown(tracer));
        MACULA_TRY_VOID(tracer.scene().setTransferFunction(study_.function));
        double traceMs = 0.0;
        std::uint32_t done = 0;
        for (const std::uint32_t samples : options_.samples) {
            Watch watch;
            MACULA_TRY(const bool whole, tracer.trace(samples - done, [&] { return !progress.cancelled(); }));
            if (!whole || progress.cancelled())
                return Error{ErrorCode::cancelled, Text("The benchmark was cancelled."), {}, {}};
            traceMs += watch.lap().wallMs;
            done = samples;
            MACULA_TRY(const image::Image picture, study_.readShown(tracer));
            TradeoffPoint point{.filter = filter,
                                .denoising = denoising,
                                .bounces = bounces,
                                .samples = samples,
                                .traceMs = traceMs,
                                .displayMs = watch.lap().wallMs};
            MACULA_TRY(const std::optional<double> psnr, image::maskedPsnr(result.converged, picture, mask));
            point.psnrDb = psnr.value_or(std::numeric_limits<double>::quiet_NaN());
            MACULA_TRY(point.ssim, image::ssim(result.converged, picture));
            MACULA_TRY(const image::Flip flip, image::flip(result.converged, picture));
            point.flip = flip.mean;
            result.points.push_back(point);
            progress.advance();
        }
        return {};
    }

  private:
    const BenchStudy& study_;
    const TradeoffOptions& options_;
};

}  // namespace

Result<Tradeoff> measureTradeoff(const BenchStudy& study, const TradeoffOptions& options,
                                 Progress& progress) {
    const Bench bench(study, options);
    Tradeoff result;
    image::Mask mask;  // background is right in every picture, and would raise every PSNR
    progress.beginStage(Text("Tracing the converged picture"), options.convergedSamples);
    MACULA_TRY_VOID(bench.converge(result, mask, progress));
    progress.beginStage(Text("Measuring"), 4 * options.bounces.size() * options.samples.size());
    for (const trace::Filter filter : {trace::Filter::stochastic, trace::Filter::trilinear}) {
        for (const trace::Denoising denoising : {trace::Denoising::off, trace::Denoising::on}) {
            for (const int bounces : options.bounces)
                MACULA_TRY_VOID(bench.run(filter, denoising, bounces, mask, result, progress));
        }
    }
    return result;
}

std::vector<Plot> plotsOf(const Tradeoff& tradeoff, const TradeoffOptions& options) {
    std::vector<Plot> plots;
    for (const trace::Filter filter : {trace::Filter::stochastic, trace::Filter::trilinear}) {
        Plot flip{.title = fmt::format("Error against time, {} filtering", trace::nameOf(filter)),
                  .xTitle = "ms, for tracing and display",
                  .yTitle = "FLIP to the converged picture",
                  .logarithmicX = true,
                  .logarithmicY = true,
                  .curves = {}};
        Plot psnr = flip;
        psnr.title = fmt::format("PSNR against time, {} filtering", trace::nameOf(filter));
        psnr.yTitle = "PSNR in dB, where matter is";
        psnr.logarithmicY = false;
        for (const bool denoised : {false, true}) {
            for (const int bounces : options.bounces) {
                Curve curve{.name = fmt::format("{} bounce{}{}", bounces, bounces == 1 ? "" : "s",
                                                denoised ? ", denoised" : ""),
                            .x = {},
                            .y = {},
                            .dashed = denoised};
                Curve inDb = curve;
                for (const TradeoffPoint& point : tradeoff.points) {
                    if (point.filter != filter || point.bounces != bounces || point.isDenoised() != denoised)
                        continue;
                    curve.x.push_back(point.totalMs());
                    curve.y.push_back(point.flip);
                    inDb.x.push_back(point.totalMs());
                    inDb.y.push_back(point.psnrDb);
                }
                flip.curves.push_back(std::move(curve));
                psnr.curves.push_back(std::move(inDb));
            }
        }
        plots.push_back(std::move(flip));
        plots.push_back(std::move(psnr));
    }
    return plots;
}

}  // namespace macula::evaluate
