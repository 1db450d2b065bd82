#include "pipeline/trace/native_tables.h"

namespace macula::trace {

HostTables<PooledVoxels> nativeTables(const gpu::NativeDispatch& dispatch, const shared::TraceParams& params,
                                      const TraceVariant& variant) {
    const SceneKind& scene = variant.scene;
    const auto extinctions = dispatch.binding<const float>(2);
    const auto albedo = dispatch.binding<const glm::vec4>(3);
    const auto entries = std::size_t(params.entryCount);
    HostTables<PooledVoxels> tables{
        .voxels = {dispatch.binding<const std::uint16_t>(1).data(),
                   dispatch.binding<const std::uint32_t>(7).data(), params.gridSize,
                   (params.volumeSize.z - 1) >> 3},
        .extinctionPerMm = extinctions.data(),
        .albedo = albedo.data(),
        .bounds = dispatch.binding<const float>(4).data(),
        .environment = dispatch.binding<const EnvironmentTexel>(5).data(),
        .cumulative = dispatch.binding<const float>(6).data(),
        .additions = dispatch.binding<const glm::vec4>(11).data(),
    };
    if (scene.gradientOpacity)
        tables.gradientOpacity = extinctions.subspan(entries, std::size_t(params.gradientLast) + 1);
    if (scene.steep) tables.steep = albedo.subspan(entries);
    tables.hasSteepDensity = scene.steep && scene.steepDensity;
    if (scene.mask) tables.mask = dispatch.binding<const std::uint32_t>(8);
    if (scene.second)
        tables.second = {dispatch.binding<const std::uint16_t>(9).data(),
                         dispatch.binding<const std::uint32_t>(10).data(), params.secondGrid,
                         (params.secondSize.z - 1) >> 3};
    if (scene.tints) tables.tints = dispatch.binding<const std::uint8_t>(12);
    if (variant.usesIndirect) {
        tables.indirectTags = dispatch.binding<const std::uint32_t>(kIndirectBinding);
        tables.indirectCells = dispatch.binding<const glm::uvec4>(kIndirectBinding + 1);
    }
    return tables;
}

}  // namespace macula::trace
