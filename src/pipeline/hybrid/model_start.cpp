#include "pipeline/hybrid/model_start.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "pipeline/hybrid/initial_splats.h"
#include "pipeline/hybrid/nearest_points.h"

namespace macula::hybrid {

namespace {

constexpr double kStillThere = 1.5;  // spacings from a splat to the next point
constexpr double kLacking = 1.0;     // spacings from a point to the next splat

void appendFrom(const splat::Splats& from, std::size_t i, splat::Splats& to) {
    to.position.push_back(from.position[i]);
    to.logScale.push_back(from.logScale[i]);
    to.rotation.push_back(from.rotation[i]);
    to.opacityLogit.push_back(from.opacityLogit[i]);
    to.dc.push_back(from.dc[i]);
}

}  // namespace

Result<ModelStart> startFromPoints(trace::PathTracer& tracer, const Box& seenMm, const std::string& key,
                                   const trace::SurfacePointOptions& options, Progress& progress) {
    progress.beginStage("Finding points", 1);
    // Points are of all that can be seen from anywhere; a view is asked for all the same.
    MACULA_TRY_VOID(tracer.setView(
        {.camera = frameBox(seenMm, ViewDirection::anterior, 20.0, 1.0), .width = 64, .height = 64}));
    MACULA_TRY(const trace::SurfacePoints points,
               tracer.surfacePoints(options, [&] { return !progress.cancelled(); }));
    if (points.points.empty())
        return Error{ErrorCode::inputNotUsable,
                     "Nothing of the series can be seen.",
                     {},
                     "Choose another preset or clip."};
    progress.advance();
    return ModelStart{.splats = initialSplats(points),
                      .spacingMm = std::sqrt(points.areaMm2),
                      .seenMm = seenMm,
                      .key = key};
}

splat::Splats relativeTo(splat::Splats splats, const glm::dvec3& originMm) {
    const glm::dvec3 shift = splats.originMm - originMm;
    for (glm::vec3& position : splats.position) position = glm::vec3(glm::dvec3(position) + shift);
    splats.originMm = originMm;
    return splats;
}

splat::Splats mergedSplats(const splat::Splats& older, const splat::Splats& points, double spacingMm) {
    const splat::Splats before = relativeTo(older, points.originMm);
    const NearestPoints byPoint(points.position, kStillThere * spacingMm);
    splat::Splats merged = points;
    merged.setShDegree(0);
    merged.resize(0);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const auto point = byPoint.nearest(before.position[i]);
        if (!point) continue;
        appendFrom(before, i, merged);
        merged.dc.back() = points.dc[*point];
    }
    const NearestPoints byKept(merged.position, kLacking * spacingMm);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!byKept.nearest(points.position[i])) appendFrom(points, i, merged);
    merged.setShDegree(older.shDegree);
    return merged;
}

}  // namespace macula::hybrid
