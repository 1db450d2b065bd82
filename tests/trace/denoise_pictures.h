// Pictures with a known truth, for the denoiser's tests.
#pragma once

#include <cmath>
#include <functional>
#include <random>

#include "pipeline/trace/reference_denoiser.h"
#include "pipeline/trace/settings.h"

namespace macula::trace {

// What one pixel truly is. Samples meet matter with probability `coverage`, and then bring light around
// `light`, exponentially distributed as that of a path is, roughly.
struct TruePixel {
    double coverage = 1.0;
    glm::dvec3 albedo{0.8, 0.7, 0.6};
    glm::dvec3 light{1.0};
    double depthMm = 100.0;
    glm::dvec3 normal{0, -1, 0};
};

struct TruePicture {
    int width = 0;
    int height = 0;
    std::vector<TruePixel> pixels;

    TruePicture(int w, int h, const std::function<TruePixel(int, int)>& pixel) : width(w), height(h) {
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) pixels.push_back(pixel(x, y));
    }

    glm::dvec4 truth(std::size_t i) const {
        const TruePixel& p = pixels[i];
        return {p.coverage * p.albedo * p.light, p.coverage};
    }
    DenoiseGuides guides() const {
        DenoiseGuides result;
        for (const TruePixel& p : pixels) {
            const bool depth = p.coverage >= 0.5;
            result.surfaces.emplace_back(depth ? p.normal : glm::dvec3(0.0), depth ? p.depthMm : -1.0);
            result.matters.emplace_back(p.coverage > 0.0 ? p.albedo : glm::dvec3(0.0), p.coverage);
            result.motions.emplace_back(0.0, 0.0, depth ? 0.9 : 0.0, p.coverage > 0.0 ? p.depthMm : -1.0);
        }
        return result;
    }
    DenoiseFilm film(std::uint32_t samples, std::uint32_t seed) const {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        std::exponential_distribution<double> brightness(1.0);
        DenoiseFilm result;
        for (const TruePixel& p : pixels) {
            glm::dvec4 sum(0.0);
            double squares = 0.0;
            for (std::uint32_t s = 0; s < samples; ++s) {
                if (uniform(random) >= p.coverage) continue;
                const glm::dvec3 light = p.albedo * p.light * brightness(random);
                sum += glm::dvec4(light, 1.0);
                const double l = glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722));
                squares += l * l;
            }
            result.sums.push_back(sum);
            result.counts.push_back(samples);
            result.squares.push_back(squares);
        }
        return result;
    }
    shared::DenoisePush push() const {
        return {.imageSize = {width, height},
                .stride = 1,
                .last = 0,
                .pixelAngle = 0.001f,
                .historySamples = 0.0f,
                .firstRow = 0,
                .doubts = 1};
    }
};

// A bright and a dark half, an edge in depth, a thin veil, a slanted edge of coverage, and nothing around.
inline TruePicture scenery(int size) {
    return {size, size, [size](int x, int y) {
                const double u = (x + 0.5) / size;
                const double v = (y + 0.5) / size;
                TruePixel p;
                p.light = glm::dvec3(v < 0.5 ? 1.0 : 0.3) + 0.3 * u;
                p.depthMm = u < 0.4 ? 100.0 + 5.0 * v : 130.0;
                if (u > 0.7) p.albedo = {0.9, 0.2, 0.1};
                if (v > 0.75) p.coverage = 0.2;
                if (u < 0.15) p.coverage = 0.0;
                if (u + v > 1.7) p.coverage = 0.0;
                return p;
            }};
}

// Opaque, its light changes little from pixel to pixel, and its normals are uncertain: as in soft tissue.
inline TruePicture softTissue(int size) {
    std::mt19937 random(5);
    std::normal_distribution<double> uncertain(0.0, 0.5);
    return {size, size, [&](int x, int y) {
                TruePixel p;
                p.light = glm::dvec3(1.0 + 0.3 * std::sin(x / 9.0) * std::cos(y / 11.0));
                p.normal += glm::dvec3(uncertain(random), uncertain(random), uncertain(random));
                p.normal = glm::normalize(p.normal);
                return p;
            }};
}

// The denoiser but for its last step, in double.
inline DenoiseState filtered(const shared::DenoisePush& push, const DenoiseRecord& record,
                             const DenoiseGuides& guides, std::vector<glm::dvec4>& masses,
                             Denoising how = Denoising::on, bool takesSpecksFirst = true) {
    DenoiseState state = denoisePrepare(push, record, guides, masses);
    if (how != Denoising::little && takesSpecksFirst)
        state.colours = denoiseSpecksFirst(push, record, state, guides, masses);
    shared::DenoisePush pass = push;
    const int passes = how == Denoising::little ? 5 : 9;
    for (int i = 0; i < passes; ++i) {
        pass.stride = 1 << (i % 5);
        pass.last = i == passes - 1 ? 1 : 0;
        state = denoiseFilter(pass, state, guides, masses);
    }
    return state;
}

// The whole of the denoiser, in double.
inline std::vector<glm::dvec4> denoised(shared::DenoisePush push, const DenoiseRecord& record,
                                        const DenoiseGuides& guides, Denoising how = Denoising::on) {
    std::vector<glm::dvec4> masses;
    push.doubts = how == Denoising::little ? 0 : 1;
    const DenoiseState state = filtered(push, record, guides, masses, how);
    return how == Denoising::little ? state.colours : denoiseSpecks(push, state, guides, masses);
}
inline std::vector<glm::dvec4> denoised(const TruePicture& picture, const DenoiseFilm& film) {
    const DenoiseGuides guides = picture.guides();
    return denoised(picture.push(), denoiseGather(picture.push(), film, guides, guides, {}), guides);
}

inline double meanSquaredError(const TruePicture& picture, const std::vector<glm::dvec4>& pixels) {
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::dvec4 off = pixels[i] - picture.truth(i);
        sum += glm::dot(off, off);
    }
    return sum / double(pixels.size());
}

inline std::vector<glm::dvec4> means(const DenoiseFilm& film) {
    std::vector<glm::dvec4> result;
    for (std::size_t i = 0; i < film.sums.size(); ++i)
        result.push_back(film.sums[i] / double(std::max(film.counts[i], 1u)));
    return result;
}

}  // namespace macula::trace
