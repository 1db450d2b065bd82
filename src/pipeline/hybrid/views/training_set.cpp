#include "pipeline/hybrid/views/training_set.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

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

// Lights the views one after the other, because there may be hundreds.
Result<TrainingPictures> litByAll(trace::PathTracer& tracer, const Box& seenMm, const TrainingSet& set,
                                  ViewTracing tracing, Progress& progress) {
    LightInSpace light(pixelMm(set.traced, seenMm, tracing.sizePx));
    tracing.light = &light;
    MACULA_TRY(TracedViews traced, traceViews(tracer, set.traced, tracing, progress));
    light.finish();
    MACULA_TRY(const LightTable table, LightTable::create(tracer.device(), light));
    TrainingPictures pictures{.traced = std::move(traced.views), .areLit = true};
    const double own = kSeenByOneIn / (kSeenByOneIn + double(pictures.traced.size()));
    progress.beginStage("Lighting views", set.traced.size() + set.sides.size());
    const auto lightNext = [&](const Camera& camera) -> Result<TracedView> {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "Stopped.", {}, {}};
        progress.advance();
        return table.lit(tracer, camera, tracing.sizePx);
    };
    for (TracedView& view : pictures.traced) {
        MACULA_TRY(TracedView lit, lightNext(view.camera));
        view = combined(view, std::move(lit), own);
    }
    std::vector<Camera> sides = std::move(traced.leftOut);
    sides.insert(sides.end(), set.sides.begin(), set.sides.end());
    for (const Camera& camera : sides) {
        if (tracing.hasTimeToLight && !tracing.hasTimeToLight()) break;
        MACULA_TRY(TracedView lit, lightNext(camera));
        pictures.sides.push_back(std::move(lit));
    }
    return pictures;
}

}  // namespace

Result<TrainingPictures> makePictures(trace::PathTracer& tracer, const Box& seenMm, const TrainingSet& set,
                                      const ViewTracing& tracing, Progress& progress) {
    if (std::abs(tracer.anisotropy()) > kMostAnisotropy || set.traced.empty()) {
        MACULA_TRY(TracedViews traced, traceViews(tracer, set.traced, tracing, progress));
        MACULA_TRY(std::vector<TracedView> sides,
                   coverageViews(tracer, set.sides, tracing.sizePx, progress, tracing.hasTimeToLight));
        return TrainingPictures{
            .traced = std::move(traced.views), .sides = std::move(sides), .fromKept = traced.fromKept};
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
    return asPictures(std::move(views), set.traced.size());
}

}  // namespace macula::hybrid
