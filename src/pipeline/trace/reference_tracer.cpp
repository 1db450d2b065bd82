#include "pipeline/trace/reference_tracer.h"

#include "pipeline/trace/clip_params.h"
#include "pipeline/trace/reference_kernels.h"
#include "shared/indirect_light.h"

namespace macula::trace {

namespace reference {
namespace {

#define MACULA_VOXELS LinearVoxels
#define MACULA_HOST HostTwofold
#define MACULA_REAL double
#include "pipeline/trace/shader_host.inl"
#undef MACULA_HOST
#undef MACULA_REAL
// The host in float with strict maths: for everything but whole pictures.
#define MACULA_HOST HostStrictSingle
#define MACULA_REAL float
#include "pipeline/trace/shader_host.inl"

// Calls use(host) with the host of the given precision.
template <class Use>
auto withHost(const ReferenceTracer::Tables& tables, const shared::TraceParams& params, Filter filter,
              Precision precision, const Use& use) {
    if (precision == Precision::twofold) return use(HostTwofold(hostTables(tables, params), params, filter));
    return use(HostStrictSingle(hostTables(tables, params), params, filter));
}

}  // namespace
}  // namespace reference

ReferenceTracer::ReferenceTracer(const Volume& volume, const Medium& medium, const Environment& environment,
                                 const MaskBits* mask, const Additions& additions) {
    auto tables = std::make_shared<Tables>();
    tables->entries.resize(volume.voxels().size());
    writeEntries(volume, entryMapOf(volume), 0, tables->entries);
    tables->extinctionPerMm = medium.extinctionPerMm;
    tables->gradientOpacity = medium.gradientOpacity;
    tables->albedo = medium.albedo;
    tables->steep = medium.steep;
    tables->bounds = medium.bounds;
    tables->environment.assign(environment.texels().begin(), environment.texels().end());
    tables->cumulative.assign(environment.cumulative().begin(), environment.cumulative().end());
    if (mask != nullptr) tables->mask = mask->words;
    if (additions.second) {
        const Volume& second = *additions.second->volume;
        tables->secondEntries.resize(second.voxels().size());
        writeEntries(second, entryMapOf(second), 0, tables->secondEntries);
    }
    tables->additions = additionTable(additions);
    if (additions.tints) tables->tints = additions.tints->box->voxels;
    tables_ = std::move(tables);
}

void ReferenceTracer::useIndirect(std::vector<std::uint32_t> tags, std::vector<glm::uvec4> cells) {
    auto tables = std::make_shared<Tables>(*tables_);
    tables->indirectTags = std::move(tags);
    tables->indirectCells = std::move(cells);
    tables_ = std::move(tables);
}

std::vector<glm::dvec4> ReferenceTracer::trace(const shared::TraceParams& params, Filter filter,
                                               Precision precision, std::uint32_t firstSample,
                                               std::uint32_t sampleCount) const {
    if (precision == Precision::single) {
        return reference::traceSingle(*tables_, params, filter, firstSample, sampleCount);
    }
    return reference::traceOn(reference::HostTwofold(reference::hostTables(*tables_, params), params, filter),
                              firstSample, sampleCount);
}

std::vector<glm::dvec4> ReferenceTracer::cast(const shared::TraceParams& params, const Cast& what,
                                              Precision precision, std::uint32_t firstSample,
                                              std::uint32_t sampleCount) const {
    return reference::withHost(*tables_, params, what.filter, precision, [&](auto host) {
        return reference::castOn(host, what, firstSample, sampleCount);
    });
}

ReferenceTracer::Moments ReferenceTracer::transmittance(const shared::TraceParams& params, Filter filter,
                                                        Precision precision, const glm::dvec3& originVoxel,
                                                        const glm::dvec3& worldDirection,
                                                        std::uint32_t samples) const {
    return reference::withHost(*tables_, params, filter, precision, [&](auto host) {
        return reference::transmittanceOn(host, originVoxel, worldDirection, samples);
    });
}

glm::dvec3 ReferenceTracer::meanGradient(const shared::TraceParams& params, Filter filter,
                                         Precision precision, const glm::dvec3& pointVoxel,
                                         std::uint32_t samples) const {
    return reference::withHost(*tables_, params, filter, precision, [&](auto host) {
        return reference::meanGradientOn(host, pointVoxel, samples);
    });
}

std::vector<GuideOf<double>> ReferenceTracer::guides(const shared::TraceParams& params,
                                                     const shared::GuidePush& before,
                                                     Precision precision) const {
    return reference::withHost(*tables_, params, Filter::trilinear, precision,
                               [&](auto host) { return reference::guidesOn(host, before); });
}

std::vector<ReferenceTracer::Layers> ReferenceTracer::layers(const shared::TraceParams& params,
                                                             Precision precision) const {
    return reference::withHost(*tables_, params, Filter::trilinear, precision,
                               [&](auto host) { return reference::layersOn(host); });
}

std::vector<ReferenceTracer::Segment> ReferenceTracer::segments(const shared::TraceParams& params,
                                                                Precision precision,
                                                                const glm::dvec3& originVoxel,
                                                                const glm::dvec3& worldDirection) const {
    return reference::withHost(*tables_, params, Filter::trilinear, precision, [&](auto host) {
        return reference::segmentsOn(host, originVoxel, worldDirection);
    });
}

double ReferenceTracer::seenSolidAngle(const shared::TraceParams& params, const glm::dvec2& stored) const {
    reference::HostTwofold host(reference::hostTables(*tables_, params), params, Filter::trilinear);
    return host.seenSolidAngle({host.params.planeHalfSize, host.params.gaze, host.params.foveaRadius,
                                host.params.foveaMagnification},
                               stored);
}

std::vector<ReferenceTracer::Light> ReferenceTracer::sampleEnvironment(const shared::TraceParams& params,
                                                                       std::uint32_t samples) const {
    return reference::withHost(*tables_, params, Filter::trilinear, Precision::twofold,
                               [&](auto host) { return reference::lightsOn(host, samples); });
}

}  // namespace macula::trace
