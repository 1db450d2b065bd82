#include "pipeline/hybrid/views/coverage_views.h"

#include <utility>

#include "pipeline/hybrid/light/pixel_coverage.h"

namespace macula::hybrid {

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
