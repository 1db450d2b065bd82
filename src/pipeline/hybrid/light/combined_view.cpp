#include "pipeline/hybrid/light/combined_view.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/parallel.h"

namespace macula::hybrid {

namespace {

constexpr double kSigmaPx = 16.0;
constexpr float kMostChange = 2.0f;
constexpr float kDark = 1e-4f;  // of white: what is darker tells nothing

bool isKnown(const glm::vec4& pixel) {
    return std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b) &&
           std::isfinite(pixel.a);
}

// The weights of a Gaussian filter at distances 0, 1, 2 and so on.
std::vector<float> gaussian(double sigma) {
    std::vector<float> weights;
    for (int i = 0; i <= int(3.0 * sigma); ++i)
        weights.push_back(static_cast<float>(std::exp(-double(i) * i / (2.0 * sigma * sigma))));
    return weights;
}

// Filters along rows and transposes, so that doing it twice filters along both axes. Weights do not add up to
// 1: only ratios are asked for.
std::vector<glm::vec3> blurredAndTurned(const std::vector<glm::vec3>& pixels, const glm::ivec2& sizePx,
                                        const std::vector<float>& weights) {
    std::vector<glm::vec3> turned(pixels.size());
    const int reach = int(weights.size()) - 1;
    parallelFor(std::size_t(sizePx.y), [&](std::size_t row) {
        const glm::vec3* from = pixels.data() + row * std::size_t(sizePx.x);
        for (int x = 0; x < sizePx.x; ++x) {
            glm::vec3 sum(0.0f);
            for (int at = std::max(x - reach, 0); at <= std::min(x + reach, sizePx.x - 1); ++at)
                sum += weights[std::size_t(std::abs(at - x))] * from[at];
            turned[std::size_t(x) * std::size_t(sizePx.y) + row] = sum;
        }
    });
    return turned;
}

std::vector<glm::vec3> blurred(const std::vector<glm::vec3>& pixels, const glm::ivec2& sizePx) {
    const std::vector<float> weights = gaussian(kSigmaPx);
    return blurredAndTurned(blurredAndTurned(pixels, sizePx, weights), {sizePx.y, sizePx.x}, weights);
}

}  // namespace

TracedView combined(const TracedView& traced, TracedView lit, double tracedShare) {
    std::vector<glm::vec3> wanted(lit.rgba.size(), glm::vec3(0.0f));
    std::vector<glm::vec3> had(lit.rgba.size(), glm::vec3(0.0f));
    for (std::size_t i = 0; i < lit.rgba.size(); ++i) {
        if (!isKnown(lit.rgba[i]) || !isKnown(traced.rgba[i])) continue;
        wanted[i] = glm::vec3(traced.rgba[i]) + kDark;
        had[i] = glm::vec3(lit.rgba[i]) + kDark;
    }
    wanted = blurred(wanted, lit.sizePx);
    had = blurred(had, lit.sizePx);
    for (std::size_t i = 0; i < lit.rgba.size(); ++i) {
        glm::vec4& pixel = lit.rgba[i];
        const glm::vec4& own = traced.rgba[i];
        if (!isKnown(pixel)) {
            pixel = own;
            continue;
        }
        glm::vec3 light(pixel);
        // Where the weight is 0 nothing was traced near the pixel.
        if (had[i].x > 0.0f) light *= glm::clamp(wanted[i] / had[i], 1.0f / kMostChange, kMostChange);
        if (isKnown(own)) light = glm::mix(light, glm::vec3(own), float(tracedShare));
        pixel = glm::vec4(light, pixel.a);
    }
    lit.samplesPerPixel = traced.samplesPerPixel;
    return lit;
}

}  // namespace macula::hybrid
