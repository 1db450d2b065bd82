#include "pipeline/splat/displayed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/splat/reference_host.h"

namespace macula::splat {

namespace {

using Host = reference::HostSingle;

constexpr std::size_t kPixelsAtOnce = 1 << 14;

void overPixels(std::size_t count, const std::function<void(std::size_t)>& body) {
    parallelFor((count + kPixelsAtOnce - 1) / kPixelsAtOnce, [&](std::size_t chunk) {
        const std::size_t end = std::min(count, (chunk + 1) * kPixelsAtOnce);
        for (std::size_t i = chunk * kPixelsAtOnce; i < end; ++i) body(i);
    });
}

float greatest(const glm::vec3& c) {
    return std::max({c.x, c.y, c.z});
}
float least(const glm::vec3& c) {
    return std::min({c.x, c.y, c.z});
}

// Of toneMapNeutral (shaders/lib/picture.glsl), step by step in the opposite order.
glm::vec3 beforeToneMap(glm::vec3 mapped) {
    constexpr float kStart = 0.8f - 0.04f;
    constexpr float kRoom = 1.0f - kStart;
    constexpr float kDesaturation = 0.15f;
    constexpr float kWhite = 0.995f;  // white itself is infinitely bright
    const float peak = std::min(greatest(mapped), kWhite);
    if (peak >= kStart) {
        const float before = kRoom * kRoom / (1.0f - peak) - kRoom + kStart;
        const float colourful = 1.0f / (kDesaturation * (before - peak) + 1.0f);
        const glm::vec3 vivid =
            (glm::min(mapped, glm::vec3(peak)) - peak * (1.0f - colourful)) / colourful * (before / peak);
        mapped = least(vivid) >= 0.0f ? vivid : mapped * (0.999f * kStart / peak);
    }
    const float low = least(mapped);
    return mapped + (low < 0.04f ? std::sqrt(low / 6.25f) - low : 0.04f);
}

std::uint8_t byteOf(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

}  // namespace

std::vector<std::uint8_t> displayed(std::span<const glm::vec4> pixels, ColourSpace space,
                                    const DisplayOptions& options) {
    Host host({}, {});
    const auto decode = [&](float encoded) { return host.decodeSrgb(encoded); };
    const glm::vec3& b = options.background;
    const glm::vec3 linear = beforeToneMap({decode(b.x), decode(b.y), decode(b.z)});
    std::vector<std::uint8_t> bytes(pixels.size() * 4);
    overPixels(pixels.size(), [&](std::size_t i) {
        const glm::vec4& p = pixels[i];
        const glm::vec3 shown = space == ColourSpace::linear
                                    ? host.displayColour(p, linear, options.exposure)
                                    : glm::vec3(p) + b * (1.0f - std::clamp(p.w, 0.0f, 1.0f));
        for (int k = 0; k < 3; ++k) bytes[4 * i + std::size_t(k)] = byteOf(shown[k]);
        bytes[4 * i + 3] = 255;
    });
    return bytes;
}

std::vector<glm::vec4> linearRadiance(std::span<const glm::vec4> pixels, ColourSpace space) {
    std::vector<glm::vec4> result(pixels.begin(), pixels.end());
    if (space == ColourSpace::linear) return result;
    Host host({}, {});
    overPixels(result.size(), [&](std::size_t i) {
        glm::vec4& p = result[i];
        if (!(p.w > 0.0f)) return;
        for (int k = 0; k < 3; ++k) p[k] = p.w * host.decodeSrgb(p[k] / p.w);
    });
    return result;
}

std::vector<float> meanDepthsMm(std::span<const glm::vec4> pixels, std::span<const float> depthSums,
                                float minCoverage) {
    MACULA_CHECK_EQ(pixels.size(), depthSums.size());
    std::vector<float> depths(pixels.size(), std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < depths.size(); ++i) {
        if (pixels[i].w > minCoverage) depths[i] = depthSums[i] / pixels[i].w;
    }
    return depths;
}

}  // namespace macula::splat
