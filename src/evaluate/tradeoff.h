// Speed against accuracy: the error of a traced picture to a converged one, and its time, over the settings
// that trade one for the other.
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/svg_plot.h"
#include "image/image.h"

namespace macula::evaluate {

struct TradeoffOptions {
    double exposure = 1.0;
    std::vector<std::uint32_t> samples{1, 2, 4, 8, 16, 32};  // ascending
    std::vector<int> bounces{2, 4, 8, 16, 32};
    // Of the converged picture, which is trilinear and not denoised.
    std::uint32_t convergedSamples = 1024;
    int convergedBounces = 64;
};

struct TradeoffPoint {
    trace::Filter filter = trace::Filter::trilinear;
    trace::Denoising denoising = trace::Denoising::off;
    int bounces = 1;
    std::uint32_t samples = 1;
    double traceMs = 0.0;    // for all samples
    double displayMs = 0.0;  // guides and denoising, if any, and the tone map
    // Errors to the converged picture, display-encoded over black. PSNR covers pixels with matter in that
    // picture.
    double psnrDb = 0.0;
    double ssim = 0.0;
    double flip = 0.0;

    bool isDenoised() const { return denoising == trace::Denoising::on; }
    double totalMs() const { return traceMs + displayMs; }
};

struct Tradeoff {
    std::vector<TradeoffPoint> points;
    image::Image converged;
    double convergedMs = 0.0;
    // The remaining noise of the converged picture: FLIP of the first half of its samples to all.
    double convergedFlip = 0.0;
    // Samples that the converged picture lost: not finite, or abandoned as too long for the device.
    std::uint64_t convergedLost = 0;
};

Result<Tradeoff> measureTradeoff(const BenchStudy& study, const TradeoffOptions& options, Progress& progress);

// FLIP and PSNR over time, by filter, with a curve for each number of bounces, dashed if denoised.
std::vector<Plot> plotsOf(const Tradeoff& tradeoff, const TradeoffOptions& options);

}  // namespace macula::evaluate
