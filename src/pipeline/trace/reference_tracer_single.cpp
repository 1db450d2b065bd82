// The reference in float, apart from the rest so that it can be compiled for the speed of this machine
// (CMakeLists.txt): the benchmark must compare against a fast CPU tracer.
#include "pipeline/trace/clip_params.h"
#include "pipeline/trace/reference_kernels.h"
#include "shared/indirect_light.h"

namespace macula::trace::reference {

namespace {
#define MACULA_HOST HostSingle
#define MACULA_REAL float
#define MACULA_VOXELS LinearVoxels
#include "pipeline/trace/shader_host.inl"
}  // namespace

std::vector<glm::dvec4> traceSingle(const ReferenceTracer::Tables& tables, const shared::TraceParams& params,
                                    Filter filter, std::uint32_t firstSample, std::uint32_t sampleCount) {
    return traceOn(HostSingle(hostTables(tables, params), params, filter), firstSample, sampleCount);
}

}  // namespace macula::trace::reference
