// The slow reference: the same GLSL maths (shaders/lib) compiled as scalar C++, in float and in double. Tests
// compare the device with it, and `macula-bench trace` times the device against it.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "pipeline/trace/guide_pixel.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/trace/scene.h"
#include "shared/pixel_layers.h"

namespace macula::trace {

enum class Precision { single, twofold };

// Immutable; may be used from several threads.
class ReferenceTracer {
  public:
    // Keeps a copy of the voxels, the tables and the environment. The medium must have been made with the
    // same additions.
    ReferenceTracer(const Volume& volume, const Medium& medium, const Environment& environment,
                    const MaskBits* mask = nullptr, const Additions& additions = {});

    // From now on trace() uses a cache of indirect light with this IndirectCache::Content; with none if both
    // are empty.
    void useIndirect(std::vector<std::uint32_t> tags, std::vector<glm::uvec4> cells);

    // Sum over samples [firstSample, firstSample + sampleCount) of premultiplied radiance and coverage, for
    // each pixel, row 0 on top; the same samples the device draws. On all cores.
    std::vector<glm::dvec4> trace(const shared::TraceParams& params, Filter filter, Precision precision,
                                  std::uint32_t firstSample, std::uint32_t sampleCount) const;

    // The same for ray casting. The medium must have been made for the same kind: matter, or that projection.
    struct Cast {
        int kind = shared::kCastMatter;  // of trace_params.h
        bool shading = false;
        Filter filter = Filter::trilinear;  // as filterOf() returns it
    };
    std::vector<glm::dvec4> cast(const shared::TraceParams& params, const Cast& what, Precision precision,
                                 std::uint32_t firstSample, std::uint32_t sampleCount) const;

    // Sum over `samples` of the ratio-tracked transmittance along one ray, and of its square.
    struct Moments {
        double sum = 0.0;
        double sumOfSquares = 0.0;
    };
    Moments transmittance(const shared::TraceParams& params, Filter filter, Precision precision,
                          const glm::dvec3& originVoxel, const glm::dvec3& worldDirection,
                          std::uint32_t samples) const;

    // The mean over `samples` of the random gradients from which paths take the normal of a surface: table
    // entries per mm along the world's axes. The point is in voxel coordinates, integers at voxel faces.
    glm::dvec3 meanGradient(const shared::TraceParams& params, Filter filter, Precision precision,
                            const glm::dvec3& pointVoxel, std::uint32_t samples) const;

    // The guides of each pixel, by its centre ray; row 0 on top.
    std::vector<GuideOf<double>> guides(const shared::TraceParams& params, const shared::GuidePush& before,
                                        Precision precision) const;

    struct Layers {
        std::array<double, shared::kPixelLayers> middleMm{};  // as PixelLayers
        double coverage = 0.0;
        double meanMm = -1.0;
    };
    std::vector<Layers> layers(const shared::TraceParams& params, Precision precision) const;

    struct Segment {
        double beginMm = 0.0;
        double endMm = 0.0;
        double majorantPerMm = 0.0;
    };
    // The segments that the walk through the brick grid visits along one ray.
    std::vector<Segment> segments(const shared::TraceParams& params, Precision precision,
                                  const glm::dvec3& originVoxel, const glm::dvec3& worldDirection) const;

    // Steradians shown by a unit of area of the stored picture at the point `stored`: see
    // shaders/lib/fovea.glsl.
    double seenSolidAngle(const shared::TraceParams& params, const glm::dvec2& stored) const;

    struct Light {
        glm::dvec3 direction{0.0};
        glm::dvec3 radiance{0.0};
        double pdfPerSr = 0.0;
        int texelAgain = 0;  // the texel that `direction` falls into
    };
    std::vector<Light> sampleEnvironment(const shared::TraceParams& params, std::uint32_t samples) const;

    struct Tables {
        std::vector<std::uint16_t> entries;  // voxels, as positions in the tables
        std::vector<float> extinctionPerMm;
        std::vector<float> gradientOpacity;  // may be empty
        std::vector<glm::vec4> albedo;
        std::vector<glm::vec4> steep;  // Medium::steep; may be empty
        std::vector<float> bounds;
        std::vector<EnvironmentTexel> environment;
        std::vector<float> cumulative;
        std::vector<std::uint32_t> mask;           // a bit for each voxel; empty: no mask
        std::vector<std::uint16_t> secondEntries;  // of a second volume; empty: there is none
        std::vector<glm::vec4> additions;          // of the second volume and segments: additionTable
        std::vector<std::uint8_t> tints;           // segment of each voxel, in their box; empty: none
        std::vector<std::uint32_t> indirectTags;   // see useIndirect
        std::vector<glm::uvec4> indirectCells;
    };

  private:
    std::shared_ptr<const Tables> tables_;
};

}  // namespace macula::trace
