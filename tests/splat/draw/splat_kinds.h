// Splats of all kinds and views of them, for tests that hold kernels to the maths in double.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "pipeline/splat/draw/reference_host.h"
#include "splat/draw/reference_scenes.h"

namespace macula::splat {

using SingleSplat = reference::HostSingle::Splat;

// Ordinary splats, and then what raster_extremes_test.cpp is about.
inline std::vector<SingleSplat> splatsOfAllKinds() {
    std::vector<SingleSplat> splats;
    Dice dice(17);
    for (int i = 0; i < 400; ++i) {
        SingleSplat splat{dice.vec3(-50, 50), dice.vec3(-2, 3), dice.quaternion(),
                          float(dice.uniform(-4, 6))};
        if (i % 4 == 1) splat.logScale.x = 6.0f;    // needles
        if (i % 4 == 2) splat.logScale.y = -12.0f;  // discs
        if (i % 8 == 3) splat.position.y = float(dice.uniform(-520, -480));
        if (i % 8 == 7) splat.position *= 6.0f;
        splats.push_back(splat);
    }
    const SingleSplat plain{{0, 0, 0}, {0, 1, 2}, {1, 0, 0, 0}, 1.0f};
    const auto with = [&](auto change) {
        SingleSplat splat = plain;
        change(splat);
        splats.push_back(splat);
    };
    for (const float logScale : {-100.0f, -20.0f, 20.0f, 100.0f}) {
        with([&](SingleSplat& s) { s.logScale = glm::vec3(logScale); });
        with([&](SingleSplat& s) { s.logScale.x = logScale; });
    }
    for (const float length : {0.0f, 1e-35f, 1e-6f, 1e6f, 1e37f})
        with([&](SingleSplat& s) { s.rotation = glm::vec4(length, -length, 0.5f * length, 0); });
    for (const float logit : {-80.0f, 80.0f, 1e38f}) with([&](SingleSplat& s) { s.opacityLogit = logit; });
    for (const float far : {-1e30f, -501.0f, -500.0f, 1e5f, 1e20f, 1e38f})
        with([&](SingleSplat& s) { s.position.y = far; });
    return splats;
}

// The last of the list above: those that may not be drawn.
inline std::vector<SingleSplat> splatsNotFinite() {
    std::vector<SingleSplat> splats;
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        for (int k = 0; k < 11; ++k) {
            SingleSplat splat{{0, 0, 0}, {0, 1, 2}, {1, 0, 0, 0}, 1.0f};
            (k < 3    ? splat.position[k]
             : k < 6  ? splat.logScale[k - 3]
             : k < 10 ? splat.rotation[k - 6]
                      : splat.opacityLogit) = bad;
            splats.push_back(splat);
        }
    }
    return splats;
}

inline RasterView someView() {
    RasterView view = frontView({160, 120});
    view.focalPx = {1000, 900};
    return view;
}

inline RasterView someParallelView() {
    RasterView view = parallelFrontView({160, 120});
    view.focalPx = {2.0, 1.8};
    return view;
}

// The largest difference of two vectors, relative to the length of the second, or to `least`.
template <int n, class Real>
double differenceOf(const glm::vec<n, float>& a, const glm::vec<n, Real>& b, double least = 1e-6) {
    const glm::vec<n, double> exact(b);
    return glm::length(glm::vec<n, double>(a) - exact) / std::max(glm::length(exact), least);
}
inline double differenceOf(float a, double b) {
    return differenceOf(glm::vec1(a), glm::dvec1(b));
}

}  // namespace macula::splat
