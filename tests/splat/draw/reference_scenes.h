// Models and views for tests of the reference rasterizer.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pipeline/splat/draw/reference_rasterizer.h"

namespace macula::splat {

class Dice {
  public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}
    double uniform(double low, double high) { return low + (high - low) * (engine_() + 0.5) / 4294967296.0; }
    double normal() {  // Box and Muller
        const double radius = std::sqrt(-2.0 * std::log(uniform(0, 1)));
        return radius * std::cos(6.283185307179586 * uniform(0, 1));
    }
    glm::dvec3 vec3(double low, double high) {
        return {uniform(low, high), uniform(low, high), uniform(low, high)};
    }
    glm::dvec4 quaternion() { return {normal(), normal(), normal(), normal()}; }

  private:
    std::mt19937 engine_;
};

// From in front of the patient, half a metre away; about 0.23 px per mm at the origin for 24 rows.
inline RasterView frontView(const glm::ivec2& sizePx = {28, 24}, double verticalFovDeg = 12.0) {
    const Camera camera{.positionMm = {0, -500, 0}, .verticalFovDeg = verticalFovDeg};
    return rasterView(camera, sizePx, glm::dvec3(0.0)).value();
}

// The same with parallel rays, and as many pixels per mm at the origin.
inline RasterView parallelFrontView(const glm::ivec2& sizePx = {28, 24}, double heightMm = 105.0) {
    const Camera camera{.positionMm = {0, -500, 0}, .parallelHeightMm = heightMm};
    return rasterView(camera, sizePx, glm::dvec3(0.0)).value();
}

inline ReferenceSplats emptyModel(std::size_t count, int degree = 0) {
    ReferenceSplats splats(count, degree);
    for (auto& q : splats.rotation) q = {1, 0, 0, 0};
    return splats;
}

// One sphere at the origin, of a deviation in mm, opacity 0.9, red.
inline ReferenceSplats oneSplat(double deviationMm, double logit = 2.1972245773362196) {
    ReferenceSplats splats = emptyModel(1);
    splats.logScale[0] = glm::dvec3(std::log(deviationMm));
    splats.opacityLogit[0] = logit;
    splats.dc[0] = glm::dvec3(0.5, -0.5, -0.5) / 0.28209479177387814;
    return splats;
}

// Splats of a few pixels each around the origin, of all shapes and some overlap, colours away from 0.
inline ReferenceSplats randomModel(std::uint32_t seed, std::size_t count, int degree = 1) {
    Dice dice(seed);
    ReferenceSplats splats = emptyModel(count, degree);
    for (std::size_t i = 0; i < count; ++i) {
        splats.position[i] = dice.vec3(-40, 40);
        splats.logScale[i] = dice.vec3(std::log(0.5), std::log(20.0));
        splats.rotation[i] = 2.0 * dice.quaternion();
        splats.opacityLogit[i] = dice.uniform(-2, 3);
        splats.dc[i] = dice.vec3(-0.2, 3);
        for (std::size_t k = 0; k < shCount(degree); ++k)
            splats.sh[i * shCount(degree) + k] = dice.vec3(-0.3, 0.3);
    }
    return splats;
}

// The same in the precision of models.
inline Splats singleOf(const ReferenceSplats& model) {
    Splats splats;
    splats.resize(model.size());
    splats.setShDegree(model.shDegree);
    for (std::size_t i = 0; i < model.size(); ++i) {
        splats.position[i] = model.position[i];
        splats.logScale[i] = model.logScale[i];
        splats.rotation[i] = model.rotation[i];
        splats.opacityLogit[i] = static_cast<float>(model.opacityLogit[i]);
        splats.dc[i] = model.dc[i];
    }
    for (std::size_t k = 0; k < model.sh.size(); ++k) splats.sh[k] = model.sh[k];
    return splats;
}

inline const glm::dvec4& at(const RasterImage& image, int column, int row) {
    return image.rgba[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.sizePx.x) +
                      static_cast<std::size_t>(column)];
}

inline double coverageSum(const RasterImage& image) {
    double sum = 0.0;
    for (const glm::dvec4& pixel : image.rgba) sum += pixel.a;
    return sum;
}

inline bool isFinite(const glm::dvec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}
inline bool isFinite(const glm::dvec3& v) {
    return isFinite(glm::dvec4(v, 0.0));
}

}  // namespace macula::splat
