#include "image/ssim.h"

#include <cmath>

namespace macula::image {

namespace {

Plane product(const Plane& a, const Plane& b) {
    Plane result(a.width, a.height);
    for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] = a.values[i] * b.values[i];
    return result;
}

std::vector<double> ssimWindow() {
    constexpr int kRadius = 5;
    constexpr double kSigma = 1.5;
    std::vector<double> weights;
    double sum = 0.0;
    for (int k = -kRadius; k <= kRadius; ++k)
        sum += weights.emplace_back(std::exp(-k * k / (2 * kSigma * kSigma)));
    for (double& weight : weights) weight /= sum;
    return weights;
}

}  // namespace

std::vector<Plane> ssimMaps(const Image& reference, const Image& test, Edge edge) {
    constexpr double kC1 = 0.01 * 0.01;
    constexpr double kC2 = 0.03 * 0.03;
    std::vector<Plane> maps;
    const auto a = colourPlanes(reference);
    const auto b = colourPlanes(test);
    const std::vector<double> window = ssimWindow();
    const auto blur = [&](const Plane& plane) { return filter(plane, window, window, edge); };
    for (std::size_t c = 0; c < a.size(); ++c) {
        const Plane meanA = blur(a[c]);
        const Plane meanB = blur(b[c]);
        const Plane squareA = blur(product(a[c], a[c]));
        const Plane squareB = blur(product(b[c], b[c]));
        const Plane cross = blur(product(a[c], b[c]));
        Plane& map = maps.emplace_back(reference.width, reference.height);
        for (std::size_t i = 0; i < meanA.values.size(); ++i) {
            const double ma = meanA.values[i];
            const double mb = meanB.values[i];
            const double va = squareA.values[i] - ma * ma;
            const double vb = squareB.values[i] - mb * mb;
            const double vab = cross.values[i] - ma * mb;
            map.values[i] =
                (2 * ma * mb + kC1) * (2 * vab + kC2) / ((ma * ma + mb * mb + kC1) * (va + vb + kC2));
        }
    }
    return maps;
}

}  // namespace macula::image
