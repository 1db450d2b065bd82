#include "evaluate/specks.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/srgb.h"
#include "evaluate/shown_picture.h"
#include "image/metrics.h"

namespace macula::evaluate {

namespace {

constexpr double kTenth = 0.1;
constexpr double kStep = 1.01 / 255.0;  // a little more than one step, against rounding
constexpr int kAround = 2;              // pixels to each side

bool isAStepAbove(double high, double low) {
    return encodedSrgb(high) - encodedSrgb(low) > kStep;
}

}  // namespace

Specks specksOf(const image::Image& shown, const image::Image& converged) {
    MACULA_CHECK(shown.width == converged.width && shown.height == converged.height);
    const std::vector<double> lights = luminancesOf(shown);
    const std::vector<double> truths = luminancesOf(converged);
    Specks specks;
    double light = 0.0;
    double truth = 0.0;
    for (int y = 0; y < shown.height; ++y) {
        for (int x = 0; x < shown.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(shown.width) + std::size_t(x);
            double least = truths[i];
            double most = truths[i];
            for (int v = std::max(y - kAround, 0); v <= std::min(y + kAround, shown.height - 1); ++v) {
                for (int u = std::max(x - kAround, 0); u <= std::min(x + kAround, shown.width - 1); ++u) {
                    const double other = truths[std::size_t(v) * std::size_t(shown.width) + std::size_t(u)];
                    least = std::min(least, other);
                    most = std::max(most, other);
                }
            }
            light += lights[i];
            truth += truths[i];
            if (lights[i] > 0.0 || truths[i] > 0.0) ++specks.pixels;
            if (lights[i] > (1.0 + kTenth) * most && isAStepAbove(lights[i], most)) {
                ++specks.bright;
                specks.worst = std::max(specks.worst, lights[i] / std::max(most, kStep / 12.92));
            }
            if (lights[i] < (1.0 - kTenth) * least && isAStepAbove(least, lights[i])) ++specks.dark;
        }
    }
    if (truth > 0.0) specks.lightRatio = light / truth;
    return specks;
}

Result<void> check(const BenchStudyOptions& /*study*/, const SpecksOptions& options) {
    std::uint32_t before = 0;
    for (const std::uint32_t samples : options.samples) {
        if (samples <= before || samples >= options.convergedSamples)
            return Error{ErrorCode::usage,
                         Text("The numbers of samples do not ascend to that of the converged picture."),
                         {},
                         Text("Give them in order, such as --samples 1 2 4, below --truth-spp.")};
        before = samples;
    }
    return {};
}

Result<SpecksReport> measureSpecks(const BenchStudy& study, const SpecksOptions& options,
                                   Progress& progress) {
    progress.beginStage(Text("Tracing the converged picture"), options.convergedSamples);
    SpecksReport report;
    trace::Settings settings{.bounces = options.bounces, .seed = 12345, .filter = options.filter};
    MACULA_TRY(trace::PathTracer truthTracer, study.makeTracer());
    MACULA_TRY_VOID(truthTracer.setSettings(settings));
    MACULA_TRY_VOID(traceMore(truthTracer, options.convergedSamples / 2, progress));
    MACULA_TRY(const image::Image half, study.readShown(truthTracer));
    MACULA_TRY_VOID(
        traceMore(truthTracer, options.convergedSamples - options.convergedSamples / 2, progress));
    MACULA_TRY(const image::Image converged, study.readShown(truthTracer));
    MACULA_TRY(const image::Flip left, image::flip(converged, half));
    report.convergedFlip = left.mean;

    progress.beginStage(Text("Tracing few samples"), options.samples.empty() ? 1 : options.samples.back());
    settings.seed = 1;
    settings.denoising = trace::Denoising::on;
    MACULA_TRY(trace::PathTracer tracer, study.makeTracer());
    MACULA_TRY_VOID(tracer.setSettings(settings));
    std::uint32_t done = 0;
    for (const std::uint32_t samples : options.samples) {
        MACULA_TRY_VOID(traceMore(tracer, samples - done, progress));
        done = samples;
        MACULA_TRY(const image::Image shown, study.readShown(tracer));
        MACULA_TRY(const image::Flip flip, image::flip(converged, shown));
        report.rows.push_back({samples, specksOf(shown, converged), flip.mean});
    }
    return report;
}

nlohmann::ordered_json reportOf(const BenchStudy& study, const SpecksOptions& options,
                                const SpecksReport& report) {
    nlohmann::ordered_json json = describe("specks", study);
    json["bounces"] = options.bounces;
    json["filter"] = trace::nameOf(options.filter);
    json["truthSamplesPerPixel"] = options.convergedSamples;
    json["truthFlip"] = report.convergedFlip;
    json["rows"] = nlohmann::ordered_json::array();
    for (const SpecksRow& row : report.rows)
        json["rows"].push_back({{"samplesPerPixel", row.samples},
                                {"brightSpecks", row.specks.bright},
                                {"darkSpecks", row.specks.dark},
                                {"pixels", row.specks.pixels},
                                {"worst", row.specks.worst},
                                {"lightRatio", row.specks.lightRatio},
                                {"flip", row.flip}});
    return json;
}

}  // namespace macula::evaluate
