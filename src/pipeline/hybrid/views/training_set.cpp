#include "pipeline/hybrid/views/training_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "base/aside.h"
#include "pipeline/hybrid/light/combined_view.h"
#include "pipeline/hybrid/light/light_in_space.h"
#include "pipeline/hybrid/light/lit_view.h"
#include "pipeline/hybrid/views/coverage_views.h"

namespace macula::hybrid {

namespace {

constexpr double kMostAnisotropy = 0.1;  // forwards 1.8 times as much light as back
// Only one in so many views sees a place from about the same side: with that many views a lit picture is as
// noisy as a traced one.
constexpr double kSeenByOneIn = 12.0;

// The size of the cells: what a pixel shows of the middle of the visible box, as a mean over the views.
// Smaller cells know too little, larger ones blur.
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

// Lights views one after the other, because there may be hundreds. While the device marches one, the picture
// before is on its way to the host, and the host makes that before it ready.
class Lighting {
  public:
    Lighting(trace::PathTracer& tracer, LightTable& table, const glm::ivec2& sizePx, ViewTimes& times)
        : tracer_(tracer), table_(table), sizePx_(sizePx), times_(times) {}

    // `ready` gets the picture, on another thread, at the latest when wait() has returned.
    Result<void> add(const Camera& camera, std::function<void(TracedView)> ready) {
        {
            const Lap lap(times_.lighting);
            MACULA_TRY_VOID(table_.begin(tracer_, camera, sizePx_, pictures_[next_]));
        }
        MACULA_TRY_VOID(makeReady());
        ready_ = [&picture = pictures_[next_], ready = std::move(ready)] { ready(picture.view()); };
        next_ = (next_ + 1) % pictures_.size();
        return {};
    }

    // For all pictures.
    Result<void> wait() {
        MACULA_TRY_VOID(makeReady());
        const Lap lap(times_.waiting);
        aside_.wait();
        times_.beside += aside_.seconds();
        return {};
    }

  private:
    // Of the picture that `ready_` is for. Waits until the one before it is ready, so that three are under
    // way at most.
    Result<void> makeReady() {
        if (!ready_) return {};
        {
            const Lap lap(times_.lighting);
            MACULA_TRY_VOID(pictures_[(next_ + pictures_.size() - 1) % pictures_.size()].finish());
        }
        const Lap lap(times_.waiting);
        aside_.begin(std::exchange(ready_, nullptr));
        return {};
    }

    trace::PathTracer& tracer_;
    LightTable& table_;
    glm::ivec2 sizePx_;
    ViewTimes& times_;
    std::array<LitPicture, 3> pictures_;
    std::size_t next_ = 0;         // of pictures_
    std::function<void()> ready_;  // for the one before it
    Aside aside_;                  // last: what it works with goes after it
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
    progress.beginStage("Lighting views", set.traced.size() + set.sides.size());
    std::vector<Camera> sides = std::move(traced.leftOut);
    sides.insert(sides.end(), set.sides.begin(), set.sides.end());
    pictures.sides.reserve(sides.size());  // where they lie they stay
    Lighting lighting(tracer, *table, tracing.sizePx, pictures.times);
    const auto lightNext = [&](const Camera& camera, std::function<void(TracedView)> ready) -> Result<void> {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "Stopped.", {}, {}};
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
    if (std::abs(tracer.anisotropy()) > kMostAnisotropy || set.traced.empty()) {
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
