// Pictures for the tests of the loss.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <random>
#include <vector>

#include "base/worst.h"
#include "pipeline/splat/train/reference_loss.h"

namespace macula::splat {

using Pixels = std::vector<glm::dvec4>;

inline Pixels filled(int width, int height, const glm::dvec4& pixel) {
    return Pixels(std::size_t(width) * std::size_t(height), pixel);
}

// Premultiplied, of all coverages, radiance from dark to four times white. The numbers are floats.
inline Pixels randomPicture(int width, int height, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    Pixels pixels;
    for (int i = 0; i < width * height; ++i) {
        const float alpha = uniform(random);
        const float light = 4.0f * std::pow(uniform(random), 3.0f);
        glm::vec4 pixel;
        for (int c = 0; c < 3; ++c) pixel[c] = alpha * light * uniform(random);
        pixel.w = alpha;
        pixels.emplace_back(pixel);
    }
    return pixels;
}

inline glm::vec3 randomBackground(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const float r = uniform(random);
    const float g = uniform(random);
    return {r, g, uniform(random)};
}

// Whether the pixel is nearer than `distance` to a kink of |x - y|, where the gradient may be that of either
// side.
inline bool atKink(const glm::dvec4& render, const glm::dvec4& target, const LossOptions& options,
                   const LossStep& step, double distance) {
    const glm::dvec4 off = glm::abs(referenceCompared(render, options, glm::dvec3(step.background)) -
                                    referenceCompared(target, options, glm::dvec3(step.background)));
    return std::min({off.x, off.y, off.z, off.w}) < distance;
}

// How far off SSIM and its relative gradient may be in a picture of one pixel: its variances are differences
// of equal squares, so all that floats leave of them is rounding, over the constant C2 of SSIM. 0 for others.
inline double roundingOfOnePixel(const Pixels& render, const Pixels& target, const LossOptions& options,
                                 const LossStep& step) {
    if (render.size() != 1) return 0.0;
    constexpr double kC2 = 0.0009;
    const glm::dvec4 sum = referenceCompared(render[0], options, glm::dvec3(step.background)) +
                           referenceCompared(target[0], options, glm::dvec3(step.background));
    const double most = std::max({std::abs(sum.x), std::abs(sum.y), std::abs(sum.z), std::abs(sum.w)});
    return double(std::numeric_limits<float>::epsilon()) * most * most / kC2;
}

inline double largest(const Pixels& pixels) {
    double result = 0.0;
    for (const glm::dvec4& pixel : pixels)
        for (int c = 0; c < 4; ++c) result = test::worse(result, std::abs(pixel[c]));
    return result;
}

}  // namespace macula::splat
