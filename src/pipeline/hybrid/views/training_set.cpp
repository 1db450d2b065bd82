#include "pipeline/hybrid/views/training_set.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "pipeline/hybrid/light/combined_view.h"
#include "pipeline/hybrid/light/light_in_space.h"
#include "pipeline/hybrid/light/lit_view.h"
#include "pipeline/hybrid/views/host_work.h"
#include "pipeline/hybrid/views/view_tracing.h"
#include "pipeline/trace/device_scene.h"

namespace macula::hybrid {

namespace {

constexpr double kMostAnisotropy = 0.1;  // 1.8 times as much light forwards as back
// Surfaces are not isotropic either, but lighting them this way costs little (docs/peripheral-model.md).
// About one in so many views sees a place from the same side: with that many views a lit picture is as noisy
// as a traced one.
constexpr double kSeenByOneIn = 12.0;

// The size of a cell: that of a pixel at the middle of the visible box, averaged over the views. Smaller
// cells get too few samples, larger ones blur.
double pixelMm(const std::vector<Camera>& cameras, const Box& seenMm, const glm::ivec2& sizePx) {
    double sum = 0.0;
    for (const Camera& camera : cameras) {
        const double halfField = std::tan(glm::radians(camera.verticalFovDeg) / 2.0);
        sum += glm::distance(camera.positionMm, seenMm.centre()) * 2.0 * halfField / double(sizePx.y);
    }
    return sum / double(cameras.size());
}

std::vector<ViewMaking> makingsOf(const TrainingSet& set, const ViewTracing& tracing) {
    std::vector<ViewMaking> makings;
    trace::Settings settings = tracing.settings;
    const auto add = [&](const Camera& camera, std::uint32_t samplesPerPixel) {
        makings.push_back({.view = {.camera = camera, .width = tracing.sizePx.x, .height = tracing.sizePx.y},
                           .settings = settings,
                           .samplesPerPixel = samplesPerPixel});
        ++settings.seed;
    };
    for (const Camera& camera : set.traced) add(camera, tracing.samplesPerPixel);
    for (const Camera& camera : set.sides) add(camera, 0);
    return makings;
}

TrainingPictures asPictures(std::vector<TracedView> views, std::size_t traced) {
    const auto sides = views.begin() + std::ptrdiff_t(traced);
    TrainingPictures pictures{.sides = {std::make_move_iterator(sides), std::make_move_iterator(views.end())},
                              .areLit = true};
    views.erase(sides, views.end());
    pictures.traced = std::move(views);
    return pictures;
}

// Lights views one after the other, because there may be hundreds. While the device marches the rays of one
// view, the previous picture is copied to the host, and the host finishes the one before that.
class Lighting {
  public:
    Lighting(trace::PathTracer& tracer, LightTable& table, const glm::ivec2& sizePx, ViewTimes& times)
        : tracer_(tracer), table_(table), sizePx_(sizePx), times_(times), host_(times.lighting, times) {}

    // Calls `ready` with the picture, on another thread, before wait() returns.
    Result<void> add(const Camera& camera, std::function<void(TracedView)> ready) {
        LitPicture& picture = host_.next();
        {
            const Lap lap(times_.lighting);
            MACULA_TRY_VOID(table_.begin(tracer_, camera, sizePx_, picture));
        }
        MACULA_TRY_VOID(host_.advance());
        host_.begun([&picture, ready = std::move(ready)] { ready(picture.view()); });
        return {};
    }

    Result<void> wait() { return host_.wait(); }  // for all pictures

  private:
    trace::PathTracer& tracer_;
    LightTable& table_;
    glm::ivec2 sizePx_;
    ViewTimes& times_;
    HostWork<LitPicture, 3> host_;
};

Result<TrainingPictures> litByAll(trace::PathTracer& tracer, const Box& seenMm, const TrainingSet& set,
                                  ViewTracing tracing, Progress& progress) {
    LightInSpace light(pixelMm(set.traced, seenMm, tracing.sizePx));
    tracing.light = &light;
    MACULA_TRY(TracedViews traced, traceViews(tracer, set.traced, tracing, progress));
    TrainingPictures pictures{.traced = std::move(traced.views), .areLit = true, .times = traced.times};
    std::optional<LightTable> table;
    {
        const Lap lap(pictures.times.lightTable);
        light.finish();
        MACULA_TRY(table, LightTable::create(tracer.device(), light));
    }
    const double own = kSeenByOneIn / (kSeenByOneIn + double(pictures.traced.size()));
    progress.beginStage(Text("Lighting views"), set.traced.size() + set.sides.size());
    std::vector<Camera> sides = std::move(traced.leftOut);
    sides.insert(sides.end(), set.sides.begin(), set.sides.end());
    pictures.sides.reserve(sides.size());  // references to elements must stay valid
    Lighting lighting(tracer, *table, tracing.sizePx, pictures.times);
    const auto lightNext = [&](const Camera& camera, std::function<void(TracedView)> ready) -> Result<void> {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
        progress.advance();
        return lighting.add(camera, std::move(ready));
    };
    for (TracedView& view : pictures.traced)
        MACULA_TRY_VOID(lightNext(
            view.camera, [&view, own](TracedView lit) { view = combined(view, std::move(lit), own); }));
    for (const Camera& camera : sides) {
        if (tracing.hasTimeToLight && !tracing.hasTimeToLight()) break;
        TracedView& side = pictures.sides.emplace_back();
        MACULA_TRY_VOID(lightNext(camera, [&side](TracedView lit) { side = std::move(lit); }));
    }
    MACULA_TRY_VOID(lighting.wait());
    return pictures;
}

}  // namespace

Result<TrainingPictures> makePictures(trace::PathTracer& tracer, const Box& seenMm, const TrainingSet& set,
                                      const ViewTracing& tracing, Progress& progress) {
    if (std::abs(tracer.scene().anisotropy()) > kMostAnisotropy || set.traced.empty()) {
        MACULA_TRY(TracedViews traced, traceViews(tracer, set.traced, tracing, progress));
        TrainingPictures pictures{
            .traced = std::move(traced.views), .fromKept = traced.fromKept, .times = traced.times};
        {
            const Lap lap(pictures.times.lighting);
            MACULA_TRY(pictures.sides,
                       coverageViews(tracer, set.sides, tracing.sizePx, progress, tracing.hasTimeToLight));
        }
        return pictures;
    }
    const std::vector<ViewMaking> makings = makingsOf(set, tracing);
    if (tracing.kept != nullptr) {
        MACULA_TRY(std::optional<std::vector<TracedView>> known, tracing.kept->findSet(makings));
        if (known) {
            TrainingPictures pictures = asPictures(std::move(*known), set.traced.size());
            pictures.fromKept = makings.size();
            return pictures;
        }
    }
    MACULA_TRY(TrainingPictures pictures, litByAll(tracer, seenMm, set, tracing, progress));
    const bool isWhole =
        pictures.traced.size() == set.traced.size() && pictures.sides.size() == set.sides.size();
    if (tracing.kept == nullptr || !isWhole) return pictures;
    std::vector<TracedView> views = std::move(pictures.traced);
    std::move(pictures.sides.begin(), pictures.sides.end(), std::back_inserter(views));
    MACULA_TRY_VOID(tracing.kept->keepSet(makings, views));
    TrainingPictures kept = asPictures(std::move(views), set.traced.size());
    kept.times = pictures.times;
    return kept;
}

}  // namespace macula::hybrid
