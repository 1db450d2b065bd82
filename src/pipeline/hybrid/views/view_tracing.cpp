#include "pipeline/hybrid/views/view_tracing.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "base/aside.h"
#include "pipeline/hybrid/light/pixel_coverage.h"
#include "pipeline/hybrid/views/host_work.h"

namespace macula::hybrid {

namespace {

Error cancelled() {
    return {ErrorCode::cancelled, Text("Stopped."), {}, {}};
}

// Adds samples in small portions, so that progress moves.
Result<void> addSamples(trace::PathTracer& tracer, const trace::View& view, const trace::Settings& settings,
                        std::uint32_t samplesPerPixel, Progress& progress) {
    constexpr std::uint32_t kPortion = 8;
    MACULA_TRY_VOID(tracer.setSettings(settings));
    MACULA_TRY_VOID(tracer.setView(view));
    for (std::uint32_t done = 0; done < samplesPerPixel;) {
        const std::uint32_t count = std::min(kPortion, samplesPerPixel - done);
        MACULA_TRY(const bool whole, tracer.trace(count, [&] { return !progress.cancelled(); }));
        if (!whole || progress.cancelled()) return cancelled();
        done += count;
        progress.advance(count);
    }
    return {};
}

// Averages coverage over pixels, and marks pixels without samples as unknown.
TracedView toLearnFrom(trace::TracedColours image, const Camera& camera) {
    const glm::ivec2 sizePx(image.width, image.height);
    const std::vector<float> coverage = pixelCoverageOf(image.coverage, sizePx);
    constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t i = 0; i < coverage.size(); ++i) {
        image.radiance[i].a = coverage[i];
        if (image.samples[i] == 0) image.radiance[i] = glm::vec4(kUnknown);
    }
    return TracedView{.camera = camera,
                      .sizePx = sizePx,
                      .rgba = std::move(image.radiance),
                      .samplesPerPixel = image.meanSamples};
}

// Traces views one after the other, and puts the light that their samples find into the radiance cache. The
// host does its work on a view while the device traces the next one.
class LitTracing {
  public:
    LitTracing(trace::PathTracer& tracer, LightInSpace& light, ViewTimes& times)
        : tracer_(tracer), light_(light), times_(times), host_(times.reading, times) {}

    // Sets `made` to the view before wait() returns.
    Result<void> add(const ViewMaking& making, std::optional<TracedView>& made, Progress& progress) {
        MACULA_TRY_VOID(tracer_.setSettings(making.settings));
        MACULA_TRY_VOID(tracer_.setView(making.view));
        if (making.samplesPerPixel == 0) {
            MACULA_TRY(made, readToLearnFrom(tracer_, making.view.camera));
        }
        for (std::uint32_t done = 0; done < making.samplesPerPixel;) {
            const std::uint32_t count = std::min(shared::kPrimarySamples, making.samplesPerPixel - done);
            {
                const Lap lap(times_.paths);
                MACULA_TRY_VOID(tracer_.addPrimaries(count, [&] { return !progress.cancelled(); }));
            }
            if (progress.cancelled()) return cancelled();
            done += count;
            const bool isWhole = done == making.samplesPerPixel;
            MACULA_TRY_VOID(host_.advance());  // the last portion has arrived by now
            const Lap lap(times_.reading);
            trace::ViewReading& reading = host_.next();
            MACULA_TRY_VOID(tracer_.beginReading(reading, {.primaries = true, .colours = isWhole}));
            host_.begun([this, &reading, camera = making.view.camera, isWhole, &made] {
                Aside picture;  // both halves are limited by memory: do them side by side
                if (isWhole) picture.begin([&] { made = toLearnFrom(reading.colours(), camera); });
                light_.addAll(camera.positionMm, reading.primaries());
                picture.wait();
            });
            progress.advance(count);
        }
        return {};
    }

    Result<void> wait() { return host_.wait(); }  // for all views

  private:
    trace::PathTracer& tracer_;
    LightInSpace& light_;
    ViewTimes& times_;
    HostWork<trace::ViewReading, 2> host_;
};

// An order by bit reversal: any first few are spread evenly over all.
std::vector<std::size_t> spreadOrder(std::size_t count) {
    std::vector<std::size_t> order;
    const std::size_t all = std::bit_ceil(std::max<std::size_t>(count, 1));
    for (std::size_t i = 0; i < all; ++i) {
        std::size_t reversed = 0;
        for (std::size_t bit = 1; bit < all; bit *= 2) reversed = 2 * reversed + ((i & bit) != 0 ? 1 : 0);
        if (reversed < count) order.push_back(reversed);
    }
    return order;
}

std::vector<std::size_t> orderOf(std::size_t count, bool mayEnd) {
    if (mayEnd) return spreadOrder(count);
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    return order;
}

}  // namespace

Result<TracedView> traceView(trace::PathTracer& tracer, const trace::View& view,
                             const trace::Settings& settings, std::uint32_t samplesPerPixel,
                             Progress& progress) {
    MACULA_TRY_VOID(addSamples(tracer, view, settings, samplesPerPixel, progress));
    MACULA_TRY(trace::TracedImage image, tracer.readback());
    return TracedView{.camera = view.camera,
                      .sizePx = {view.width, view.height},
                      .rgba = std::move(image.radiance),
                      .samplesPerPixel = double(samplesPerPixel)};
}

Result<TracedView> readToLearnFrom(trace::PathTracer& tracer, const Camera& camera) {
    MACULA_TRY(trace::TracedColours image, tracer.readColours());
    return toLearnFrom(std::move(image), camera);
}

Result<TracedViews> traceViews(trace::PathTracer& tracer, std::span<const Camera> cameras,
                               const ViewTracing& options, Progress& progress) {
    const std::uint32_t samples = options.samplesPerPixel;
    progress.beginStage(Text("Tracing views"), cameras.size() * samples);
    TracedViews learnt;
    std::vector<std::optional<TracedView>> made(cameras.size());
    std::optional<LitTracing> lit;
    if (options.light != nullptr) lit.emplace(tracer, *options.light, learnt.times);
    bool isFirst = true;
    for (const std::size_t i : orderOf(cameras.size(), bool(options.hasTimeToTrace))) {
        const Camera& camera = cameras[i];
        const bool hasTime = !options.hasTimeToTrace || options.hasTimeToTrace();
        if (!hasTime && !isFirst) break;
        isFirst = false;
        trace::Settings settings = options.settings;
        settings.seed += static_cast<std::uint32_t>(i);
        const trace::View view{.camera = camera, .width = options.sizePx.x, .height = options.sizePx.y};
        const ViewMaking making{.view = view, .settings = settings, .samplesPerPixel = samples};
        if (options.kept != nullptr && options.light == nullptr) {
            MACULA_TRY(made[i], options.kept->find(making));
            if (made[i]) {
                ++learnt.fromKept;
                progress.advance(samples);
                if (progress.cancelled()) return cancelled();
                continue;
            }
        }
        tracer.forgetViews();
        if (lit) {
            MACULA_TRY_VOID(lit->add(making, made[i], progress));
            continue;
        }
        {
            const Lap lap(learnt.times.paths);
            MACULA_TRY_VOID(addSamples(tracer, view, settings, samples, progress));
        }
        const Lap lap(learnt.times.reading);
        MACULA_TRY(made[i], readToLearnFrom(tracer, camera));
        if (options.kept != nullptr) MACULA_TRY_VOID(options.kept->keep(making, *made[i]));
    }
    if (lit) MACULA_TRY_VOID(lit->wait());
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        if (made[i]) {
            learnt.views.push_back(std::move(*made[i]));
        } else {
            learnt.leftOut.push_back(cameras[i]);
        }
    }
    return learnt;
}

PoseAcceptance showsEnough(trace::PathTracer& tracer, double radiusMm, const PoseLimits& limits,
                           const Progress& progress) {
    return [&tracer, &progress, radiusMm, limits](const Camera& camera) -> Result<bool> {
        if (progress.cancelled()) return cancelled();
        MACULA_TRY_VOID(tracer.setView({.camera = camera, .width = limits.sizePx, .height = limits.sizePx}));
        MACULA_TRY(const std::vector<trace::GuidePixel> pixels, tracer.readGuides());
        double coverage = 0.0;
        std::size_t near = 0;
        for (const trace::GuidePixel& pixel : pixels) {
            coverage += double(pixel.coverage);
            if (pixel.depthMm >= 0.0f && double(pixel.depthMm) < limits.nearRadii * radiusMm) ++near;
        }
        const auto count = double(pixels.size());
        return coverage >= limits.leastCoverage * count && double(near) <= limits.mostNear * count;
    };
}

Result<std::vector<TracedView>> coverageViews(trace::PathTracer& tracer, std::span<const Camera> cameras,
                                              const glm::ivec2& sizePx, Progress& progress,
                                              const std::function<bool()>& hasTime) {
    progress.beginStage(Text("Finding outlines"), cameras.size());
    std::vector<TracedView> views;
    for (const Camera& camera : cameras) {
        if (hasTime && !hasTime()) break;
        if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
        MACULA_TRY_VOID(tracer.setView({.camera = camera, .width = sizePx.x, .height = sizePx.y}));
        MACULA_TRY(const std::vector<trace::GuidePixel> guides, tracer.readGuides());
        TracedView view{.camera = camera, .sizePx = sizePx};
        for (const float covered : pixelCoverage(guides, sizePx))
            view.rgba.emplace_back(glm::vec3(0.0f), covered);
        views.push_back(std::move(view));
        progress.advance();
    }
    return views;
}

}  // namespace macula::hybrid
