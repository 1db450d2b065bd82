#include "pipeline/hybrid/frame/reference_reprojection.h"

#include "base/check.h"
#include "base/glsl_in_cpp.h"
#include "base/parallel.h"

namespace macula::hybrid {

namespace {

#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE

// A class, because the shader functions read their tables as globals.
struct Host : GlslInCpp<double> {
    Host(const shared::ReprojectPush& push, const ReferenceCapture& picture)
        : reproject{push.right,       push.up,       push.forward,       push.oursMm,
                    push.beforeRight, push.beforeUp, push.beforeForward, push.middleMm,
                    push.radiusMm,    push.size,     push.beforeSize,    push.firstPx,
                    push.edgeFade},
          before(&picture) {}

    struct {
        vec3 right, up, forward, oursMm, beforeRight, beforeUp, beforeForward, middleMm;
        double radiusMm;
        ivec2 size, beforeSize, firstPx;
        double edgeFade;
    } reproject;
    const ReferenceCapture* before;
    std::span<const double> expectedDepthsMm = {};

    vec4 fetchLight(int pixel) const { return before->lights[static_cast<std::size_t>(pixel)]; }
    vec2 fetchSurface(int pixel) const { return before->depths[static_cast<std::size_t>(pixel)]; }

    double fetchTrust(int pixel) const {
        return before->trusts.empty() ? 1.0 : before->trusts[static_cast<std::size_t>(pixel)];
    }
    double fetchExpected(int pixel) const {
        return expectedDepthsMm.empty() ? -1.0 : expectedDepthsMm[static_cast<std::size_t>(pixel)];
    }

#define float double
#include "lib/reproject.glsl"
#undef float
};

struct TrustHost : GlslInCpp<double> {
#define float double
#include "lib/picture.glsl"
#include "lib/trust.glsl"
#undef float
    static constexpr int kRadius = TRUST_RADIUS;
};

struct FeatherHost : GlslInCpp<double> {
    ivec2 sizePx;
    std::span<const double> weights;

    double fetchWeight(const ivec2& pixel) const {
        const ivec2 inside = clamp(pixel, ivec2(0), sizePx - ivec2(1));
        return weights[static_cast<std::size_t>(inside.y * sizePx.x + inside.x)];
    }

#define float double
#include "lib/feather.glsl"
#undef float
};

#undef OUT
#undef INOUT
#undef PRECISE

}  // namespace

ReferenceReprojection reproject(const shared::ReprojectPush& push, const ReferenceCapture& before,
                                std::span<const double> expectedMm) {
    const auto pixels = std::size_t(push.beforeSize.x) * std::size_t(push.beforeSize.y);
    MACULA_CHECK_EQ(before.lights.size(), pixels);
    MACULA_CHECK_EQ(before.depths.size(), pixels);
    const auto columns = std::size_t(push.size.x);
    const auto rows = std::size_t(push.size.y);
    ReferenceReprojection result{std::vector<glm::dvec4>(columns * rows), std::vector<double>(columns * rows),
                                 std::vector<double>(columns * rows)};
    parallelFor(rows, [&](std::size_t row) {
        Host host(push, before);
        host.expectedDepthsMm = expectedMm;
        for (std::size_t column = 0; column < columns; ++column) {
            const auto seen = host.reprojectedAt({int(column), int(row)});
            result.lights[row * columns + column] = seen.light;
            result.weights[row * columns + column] = seen.weight;
            result.trusts[row * columns + column] = seen.trust;
        }
    });
    return result;
}

std::vector<double> trustIn(const glm::ivec2& sizePx, std::span<const glm::dvec4> lights,
                            std::span<const double> variances, std::span<const glm::dvec4> splats,
                            double splatGain) {
    std::vector<double> result;
    TrustHost host;
    const glm::ivec2 reach(TrustHost::kRadius);
    for (int y = 0; y < sizePx.y; ++y) {
        for (int x = 0; x < sizePx.x; ++x) {
            const glm::ivec2 low = glm::max(glm::ivec2(x, y) - reach, glm::ivec2(0));
            const glm::ivec2 high = glm::min(glm::ivec2(x, y) + reach, sizePx - 1);
            glm::dvec2 sum(0.0);
            for (int v = low.y; v <= high.y; ++v) {
                for (int u = low.x; u <= high.x; ++u) {
                    const auto i = static_cast<std::size_t>(v * sizePx.x + u);
                    const glm::dvec4 gained = splats[i] * glm::dvec4(glm::dvec3(splatGain), 1.0);
                    sum += host.trustTerms(lights[i], variances[i], gained);
                }
            }
            result.push_back(host.trustOf(sum));
        }
    }
    return result;
}

std::vector<double> feather(const glm::ivec2& sizePx, std::span<const double> weights) {
    std::vector<double> result(weights.size());
    FeatherHost host;
    host.sizePx = sizePx;
    host.weights = weights;
    for (int y = 0; y < sizePx.y; ++y) {
        for (int x = 0; x < sizePx.x; ++x)
            result[static_cast<std::size_t>(y * sizePx.x + x)] = host.feathered({x, y});
    }
    return result;
}

}  // namespace macula::hybrid
