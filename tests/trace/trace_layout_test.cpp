// The structs that C++ and GLSL share are laid out alike.
#include <gtest/gtest.h>

#include "gpu/shared_layout.h"
#include "pipeline/gpu/spirv_reflection.h"
#include "shaders/trace.h"
#include "shared/denoise_params.h"
#include "shared/guide_params.h"
#include "shared/indirect_light.h"
#include "shared/pixel_layers.h"
#include "shared/primary_vertex.h"
#include "shared/surface_params.h"
#include "shared/trace_params.h"

namespace macula {
namespace {

using shared::DisplayPush;
using shared::PlannedBlock;
using shared::TraceParams;

#define FIELD(type, name) MACULA_FIELD(TraceParams, name),
#define ARRAY(type, name, count) FIELD(type, name)
const std::vector<LaidOutField> kTraceParams{MACULA_TRACE_PARAMS(FIELD, ARRAY)};
#undef FIELD
#undef ARRAY
const std::vector<LaidOutField> kPlannedBlock{MACULA_FIELD(PlannedBlock, block),
                                              MACULA_FIELD(PlannedBlock, firstSample),
                                              MACULA_FIELD(PlannedBlock, sampleCount)};

TEST(TraceLayout, ParametersAndPushConstantsAgreeInEveryKernel) {
    for (const auto& code : {shaders::trace_path_comp, shaders::trace_path_primaries_comp,
                             shaders::trace_cast_comp, shaders::trace_guides_comp, shaders::trace_layers_comp,
                             shaders::trace_candidates_comp, shaders::trace_surface_points_comp}) {
        const auto reflection = gpu::reflectSpirv(code.words);
        ASSERT_TRUE(reflection.ok());
        const auto* params = reflection->bindings.front().block.find("params");
        ASSERT_NE(params, nullptr) << code.name;
        expectLayoutMatches<TraceParams>(*params, kTraceParams);
    }
    for (const auto& code : {shaders::trace_path_comp, shaders::trace_cast_comp}) {
        const auto reflection = gpu::reflectSpirv(code.words);
        ASSERT_TRUE(reflection.ok());
        const auto* planned = reflection->bindings.at(21).block.find("planned");
        ASSERT_NE(planned, nullptr) << code.name;
        expectLayoutMatches<PlannedBlock>(*planned, kPlannedBlock);
    }
    const auto primaries = gpu::reflectSpirv(shaders::trace_path_primaries_comp.words);
    ASSERT_TRUE(primaries.ok());
    expectLayoutMatches<shared::PrimaryVertex>(
        *primaries->bindings.back().block.find("primaries"),
        {MACULA_FIELD(shared::PrimaryVertex, fromEyeMm), MACULA_FIELD(shared::PrimaryVertex, radiance)});
    const auto layers = gpu::reflectSpirv(shaders::trace_layers_comp.words);
    ASSERT_TRUE(layers.ok());
    expectLayoutMatches<shared::PixelLayers>(
        *layers->bindings.back().block.find("pixels"),
        {MACULA_FIELD(shared::PixelLayers, nearMm), MACULA_FIELD(shared::PixelLayers, farMm),
         MACULA_FIELD(shared::PixelLayers, coverage), MACULA_FIELD(shared::PixelLayers, meanMm)});
    expectLayoutMatches<shared::LayersPush>(*layers->pushConstants->block.find("push"),
                                            {MACULA_FIELD(shared::LayersPush, firstRow)});
    const auto noise = gpu::reflectSpirv(shaders::trace_noise_comp.words);
    ASSERT_TRUE(noise.ok());
    expectLayoutMatches<shared::BlockNoise>(
        *noise->bindings.back().block.find("noises"),
        {MACULA_FIELD(shared::BlockNoise, squaredError), MACULA_FIELD(shared::BlockNoise, isSeen)});
    expectLayoutMatches<shared::NoisePush>(
        *noise->pushConstants->block.find("push"),
        {MACULA_FIELD(shared::NoisePush, imageSize), MACULA_FIELD(shared::NoisePush, firstBlock),
         MACULA_FIELD(shared::NoisePush, exposure), MACULA_FIELD(shared::NoisePush, backdrop),
         MACULA_FIELD(shared::NoisePush, keepsHue)});
    const auto variance = gpu::reflectSpirv(shaders::trace_variance_comp.words);
    ASSERT_TRUE(variance.ok());
    expectLayoutMatches<shared::VariancePush>(*variance->pushConstants->block.find("push"),
                                              {MACULA_FIELD(shared::VariancePush, imageSize)});
    const auto guides = gpu::reflectSpirv(shaders::trace_guides_comp.words);
    ASSERT_TRUE(guides.ok());
    expectLayoutMatches<shared::GuidePush>(
        *guides->pushConstants->block.find("push"),
        {MACULA_FIELD(shared::GuidePush, oursMm), MACULA_FIELD(shared::GuidePush, right),
         MACULA_FIELD(shared::GuidePush, up), MACULA_FIELD(shared::GuidePush, forward),
         MACULA_FIELD(shared::GuidePush, planeHalfSize), MACULA_FIELD(shared::GuidePush, gaze),
         MACULA_FIELD(shared::GuidePush, foveaRadius), MACULA_FIELD(shared::GuidePush, foveaMagnification),
         MACULA_FIELD(shared::GuidePush, parallelMm), MACULA_FIELD(shared::GuidePush, firstRow)});
    for (const auto& code :
         {shaders::denoise_gather_comp, shaders::denoise_prepare_comp, shaders::denoise_filter_comp,
          shaders::denoise_specks_comp, shaders::denoise_variance_comp}) {
        const auto denoise = gpu::reflectSpirv(code.words);
        ASSERT_TRUE(denoise.ok());
        expectLayoutMatches<shared::DenoisePush>(
            *denoise->pushConstants->block.find("denoise"),
            {MACULA_FIELD(shared::DenoisePush, imageSize), MACULA_FIELD(shared::DenoisePush, stride),
             MACULA_FIELD(shared::DenoisePush, last), MACULA_FIELD(shared::DenoisePush, pixelAngle),
             MACULA_FIELD(shared::DenoisePush, historySamples), MACULA_FIELD(shared::DenoisePush, firstRow),
             MACULA_FIELD(shared::DenoisePush, planeHalfSize), MACULA_FIELD(shared::DenoisePush, gaze),
             MACULA_FIELD(shared::DenoisePush, foveaRadius),
             MACULA_FIELD(shared::DenoisePush, foveaMagnification),
             MACULA_FIELD(shared::DenoisePush, parallelMm), MACULA_FIELD(shared::DenoisePush, doubts)});
    }
    const auto display = gpu::reflectSpirv(shaders::trace_display_comp.words);
    ASSERT_TRUE(display.ok());
    expectLayoutMatches<DisplayPush>(
        *display->pushConstants->block.find("push"),
        {MACULA_FIELD(DisplayPush, background), MACULA_FIELD(DisplayPush, exposure),
         MACULA_FIELD(DisplayPush, smoothing), MACULA_FIELD(DisplayPush, denoised),
         MACULA_FIELD(DisplayPush, keepsHue)});
}

TEST(TraceLayout, OfSamplesSideBySide) {
    const auto side = gpu::reflectSpirv(shaders::trace_path_side_comp.words);
    ASSERT_TRUE(side.ok());
    expectLayoutMatches<shared::SidePush>(
        *side->pushConstants->block.find("push"),
        {MACULA_FIELD(shared::SidePush, blockCount), MACULA_FIELD(shared::SidePush, mostSamples)});
}

TEST(TraceLayout, OfIndirectLight) {
    using shared::IndirectPush, shared::IndirectRecord;
    const auto add = gpu::reflectSpirv(shaders::trace_indirect_add_comp.words);
    ASSERT_TRUE(add.ok());
    expectLayoutMatches<IndirectRecord>(
        *add->bindings.front().block.find("records"),
        {MACULA_FIELD(IndirectRecord, cells), MACULA_FIELD(IndirectRecord, light)});
    expectLayoutMatches<IndirectPush>(
        *add->pushConstants->block.find("push"),
        {MACULA_FIELD(IndirectPush, recordCount), MACULA_FIELD(IndirectPush, unit)});
}

TEST(TraceLayout, OfSurfacePoints) {
    using shared::CandidatePush, shared::SurfaceCandidate, shared::SurfaceCell, shared::SurfacePush,
        shared::SurfaceSums;
    const auto candidates = gpu::reflectSpirv(shaders::trace_candidates_comp.words);
    ASSERT_TRUE(candidates.ok());
    expectLayoutMatches<CandidatePush>(
        *candidates->pushConstants->block.find("push"),
        {MACULA_FIELD(CandidatePush, first), MACULA_FIELD(CandidatePush, round)});
    expectLayoutMatches<SurfaceCell>(
        *candidates->bindings[candidates->bindings.size() - 3].block.find("cells"),
        {MACULA_FIELD(SurfaceCell, low), MACULA_FIELD(SurfaceCell, high)});
    expectLayoutMatches<SurfaceCandidate>(
        *candidates->bindings.back().block.find("candidates"),
        {MACULA_FIELD(SurfaceCandidate, at), MACULA_FIELD(SurfaceCandidate, weight),
         MACULA_FIELD(SurfaceCandidate, density)});
    const auto points = gpu::reflectSpirv(shaders::trace_surface_points_comp.words);
    ASSERT_TRUE(points.ok());
    expectLayoutMatches<SurfacePush>(
        *points->pushConstants->block.find("push"),
        {MACULA_FIELD(SurfacePush, first), MACULA_FIELD(SurfacePush, base), MACULA_FIELD(SurfacePush, pass)});
    expectLayoutMatches<SurfaceSums>(
        *points->bindings.back().block.find("sums"),
        {MACULA_FIELD(SurfaceSums, radiance), MACULA_FIELD(SurfaceSums, coverage),
         MACULA_FIELD(SurfaceSums, lost), MACULA_FIELD(SurfaceSums, taps), MACULA_FIELD(SurfaceSums, mass),
         MACULA_FIELD(SurfaceSums, first), MACULA_FIELD(SurfaceSums, diagonal),
         MACULA_FIELD(SurfaceSums, offAxis)});
}

}  // namespace
}  // namespace macula
