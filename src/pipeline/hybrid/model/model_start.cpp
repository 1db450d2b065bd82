#include "pipeline/hybrid/model/model_start.h"

#include "pipeline/hybrid/model/initial_splats.h"

namespace macula::hybrid {

Result<ModelStart> startFromPoints(trace::PathTracer& tracer, const Box& seenMm, const std::string& key,
                                   const trace::SurfacePointOptions& options, Progress& progress) {
    progress.beginStage(Text("Finding points"), 1);
    // The search for points needs some view, though it finds what can be seen from anywhere.
    MACULA_TRY_VOID(tracer.setView(
        {.camera = frameBox(seenMm, ViewDirection::anterior, 20.0, 1.0), .width = 64, .height = 64}));
    MACULA_TRY(const trace::SurfacePoints points,
               tracer.surfacePoints(options, [&] { return !progress.cancelled(); }));
    if (points.points.empty())
        return Error{ErrorCode::inputNotUsable,
                     Text("Nothing of the series can be seen."),
                     {},
                     Text("Choose another preset or clip.")};
    progress.advance();
    return ModelStart{.splats = initialSplats(points), .seenMm = seenMm, .key = key};
}

splat::Splats relativeTo(splat::Splats splats, const glm::dvec3& originMm) {
    const glm::dvec3 shift = splats.originMm - originMm;
    for (glm::vec3& position : splats.position) position = glm::vec3(glm::dvec3(position) + shift);
    splats.originMm = originMm;
    return splats;
}

}  // namespace macula::hybrid
