// The reference tracer's loops over pixels, for a host of either precision. Internal to
// reference_tracer*.cpp.
#pragma once

#include "base/glsl_in_cpp.h"
#include "base/parallel.h"
#include "pipeline/trace/clip_params.h"
#include "pipeline/trace/host_tables.h"
#include "pipeline/trace/reference_tracer.h"

namespace macula::trace::reference {

inline HostTables<LinearVoxels> hostTables(const ReferenceTracer::Tables& tables,
                                           const shared::TraceParams& params) {
    HostTables<LinearVoxels> view{.voxels = {tables.entries.data(), params.volumeSize},
                                  .extinctionPerMm = tables.extinctionPerMm.data(),
                                  .gradientOpacity = tables.gradientOpacity,
                                  .albedo = tables.albedo.data(),
                                  .steep = tables.steep,
                                  .hasSteepDensity = !tables.steep.empty(),
                                  .bounds = tables.bounds.data(),
                                  .environment = tables.environment.data(),
                                  .cumulative = tables.cumulative.data(),
                                  .mask = tables.mask,
                                  .additions = tables.additions.data(),
                                  .tints = tables.tints,
                                  .indirectTags = tables.indirectTags,
                                  .indirectCells = tables.indirectCells};
    if (!tables.secondEntries.empty()) view.second = {tables.secondEntries.data(), params.secondSize};
    return view;
}

std::vector<glm::dvec4> traceSingle(const ReferenceTracer::Tables&, const shared::TraceParams&, Filter,
                                    std::uint32_t firstSample, std::uint32_t sampleCount);

// Mirrors shaders/trace/path.comp.
template <class Host>
std::vector<glm::dvec4> traceOn(Host prototype, std::uint32_t firstSample, std::uint32_t sampleCount) {
    const int width = prototype.params.imageSize.x;
    const int height = prototype.params.imageSize.y;
    std::vector<glm::dvec4> sums(std::size_t(width) * std::size_t(height));
    parallelFor(std::size_t(height), [&, host = prototype](std::size_t row) mutable {
        for (int x = 0; x < width; ++x) {
            glm::dvec4 sum(0.0);
            for (std::uint32_t s = firstSample; s < firstSample + sampleCount; ++s) {
                typename Host::Rng rng;
                auto path = host.startSample({x, int(row)}, s, rng);
                while (host.extendPath(path, rng)) {
                }
                sum += glm::dvec4(glm::dvec3(host.lightOf(path)), double(path.coverage));
            }
            sums[row * std::size_t(width) + std::size_t(x)] = sum;
        }
    });
    return sums;
}

// Mirrors shaders/trace/cast.comp.
template <class Host>
std::vector<glm::dvec4> castOn(Host prototype, const ReferenceTracer::Cast& what, std::uint32_t firstSample,
                               std::uint32_t sampleCount) {
    const int width = prototype.params.imageSize.x;
    const int height = prototype.params.imageSize.y;
    prototype.cast = {what.kind, what.shading};
    std::vector<glm::dvec4> sums(std::size_t(width) * std::size_t(height));
    parallelFor(std::size_t(height), [&, host = prototype](std::size_t row) mutable {
        for (int x = 0; x < width; ++x) {
            glm::dvec4 sum(0.0);
            int rounds = 0;
            for (std::uint32_t s = firstSample; s < firstSample + sampleCount; ++s)
                sum += glm::dvec4(host.castSample({x, int(row)}, s, rounds));
            sums[row * std::size_t(width) + std::size_t(x)] = sum;
        }
    });
    return sums;
}

template <class Host>
ReferenceTracer::Moments transmittanceOn(Host host, const glm::dvec3& originVoxel,
                                         const glm::dvec3& worldDirection, std::uint32_t samples) {
    ReferenceTracer::Moments moments;
    for (std::uint32_t s = 0; s < samples; ++s) {
        auto rng = host.makeRng(0u, 0u, s, host.params.seed);
        auto ray = host.startPath(typename Host::vec3(originVoxel), typename Host::vec3(worldDirection),
                                  {s, host.params.seed});
        host.beShadow(ray);
        while (!host.follow(ray, rng)) {
        }
        const double through = double(ray.transmittance);
        moments.sum += through;
        moments.sumOfSquares += through * through;
    }
    return moments;
}

template <class Host>
glm::dvec3 meanGradientOn(Host host, const glm::dvec3& pointVoxel, std::uint32_t samples) {
    glm::dvec3 sum(0.0);
    for (std::uint32_t s = 0; s < samples; ++s) {
        auto rng = host.makeRng(0u, 0u, s, host.params.seed);
        sum += glm::dvec3(host.surfaceGradientByChance(typename Host::vec3(pointVoxel), rng));
    }
    return sum / double(samples);
}

template <class Host>
std::vector<GuideOf<double>> guidesOn(Host prototype, const shared::GuidePush& before) {
    using Real = typename Host::Real;
    const int width = prototype.params.imageSize.x;
    std::vector<GuideOf<double>> pixels(std::size_t(width) * std::size_t(prototype.params.imageSize.y));
    parallelFor(std::size_t(prototype.params.imageSize.y), [&](std::size_t row) {
        Host host = prototype;  // a copy for each row, because a march writes to layerMm
        const typename Host::Eye eye{
            before.oursMm,
            before.right,
            before.up,
            before.forward,
            {before.planeHalfSize, before.gaze, Real(before.foveaRadius), Real(before.foveaMagnification)},
            Real(before.parallelMm)};
        for (int x = 0; x < width; ++x) {
            const auto guide = host.guideOf({Real(x) + Real(0.5), Real(row) + Real(0.5)}, eye);
            pixels[row * std::size_t(width) + std::size_t(x)] = {.depthMm = double(guide.depthMm),
                                                                 .confidence = double(guide.confidence),
                                                                 .coverage = double(guide.coverage),
                                                                 .beforeMm = double(guide.beforeMm),
                                                                 .albedo = guide.albedo,
                                                                 .normal = guide.normal,
                                                                 .motion = guide.motion};
        }
    });
    return pixels;
}

// Mirrors shaders/trace/layers.comp.
template <class Host>
std::vector<ReferenceTracer::Layers> layersOn(Host prototype) {
    using Real = typename Host::Real;
    const int width = prototype.params.imageSize.x;
    std::vector<ReferenceTracer::Layers> pixels(std::size_t(width) *
                                                std::size_t(prototype.params.imageSize.y));
    parallelFor(std::size_t(prototype.params.imageSize.y), [&](std::size_t row) {
        Host host = prototype;  // a copy for each row, because it holds the layers of the current ray
        for (int x = 0; x < width; ++x) {
            const auto ray = host.layersOf({Real(x) + Real(0.5), Real(row) + Real(0.5)});
            ReferenceTracer::Layers& pixel = pixels[row * std::size_t(width) + std::size_t(x)];
            pixel.coverage = double(ray.coverage);
            pixel.meanMm = double(ray.meanMm);
            for (std::size_t i = 0; i < pixel.middleMm.size(); ++i)
                pixel.middleMm[i] = double(host.layerMm[i]);
        }
    });
    return pixels;
}

template <class Host>
std::vector<ReferenceTracer::Segment> segmentsOn(Host host, const glm::dvec3& originVoxel,
                                                 const glm::dvec3& worldDirection) {
    std::vector<ReferenceTracer::Segment> segments;
    auto walk = host.startEyeWalk(typename Host::vec3(originVoxel),
                                  host.voxelsPerMm(typename Host::vec3(worldDirection)));
    int rounds = 0;
    while (host.nextSegment(walk, rounds)) {
        segments.push_back({double(walk.distanceMm), double(walk.segmentEndMm), double(walk.majorant)});
    }
    return segments;
}

template <class Host>
std::vector<ReferenceTracer::Light> lightsOn(Host host, std::uint32_t samples) {
    std::vector<ReferenceTracer::Light> lights(samples);
    for (std::uint32_t s = 0; s < samples; ++s) {
        auto rng = host.makeRng(0u, 0u, s, host.params.seed);
        const auto u = host.random01(rng);
        const auto light = host.sampleEnvironment({u, host.random01(rng)});
        lights[s] = {glm::dvec3(light.direction), glm::dvec3(light.radiance), double(light.pdfPerSr),
                     host.environmentTexel(light.direction)};
    }
    return lights;
}

}  // namespace macula::trace::reference
