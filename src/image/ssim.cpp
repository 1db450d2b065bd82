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
    constexpr double kSigma = 1.5;
    std::vector<double> weights;
    double sum = 0.0;
    for (int k = -kSsimRadius; k <= kSsimRadius; ++k)
        sum += weights.emplace_back(std::exp(-k * k / (2 * kSigma * kSigma)));
    for (double& weight : weights) weight /= sum;
    return weights;
}

}  // namespace

SsimTerms ssimTerms(const Plane& a, const Plane& b, Edge edge) {
    constexpr double kC1 = 0.01 * 0.01;
    constexpr double kC2 = 0.03 * 0.03;
    const std::vector<double> window = ssimWindow();
    const auto blur = [&](const Plane& plane) { return filter(plane, window, window, edge); };
    const Plane meanA = blur(a);
    const Plane meanB = blur(b);
    const Plane squareA = blur(product(a, a));
    const Plane squareB = blur(product(b, b));
    const Plane cross = blur(product(a, b));
    SsimTerms terms{.whole = Plane(a.width, a.height), .contrastStructure = Plane(a.width, a.height)};
    for (std::size_t i = 0; i < meanA.values.size(); ++i) {
        const double ma = meanA.values[i];
        const double mb = meanB.values[i];
        const double va = squareA.values[i] - ma * ma;
        const double vb = squareB.values[i] - mb * mb;
        const double vab = cross.values[i] - ma * mb;
        terms.whole.values[i] =
            (2 * ma * mb + kC1) * (2 * vab + kC2) / ((ma * ma + mb * mb + kC1) * (va + vb + kC2));
        terms.contrastStructure.values[i] = (2 * vab + kC2) / (va + vb + kC2);
    }
    return terms;
}

std::vector<Plane> ssimMaps(const Image& reference, const Image& test, Edge edge) {
    std::vector<Plane> maps;
    const auto a = colourPlanes(reference);
    const auto b = colourPlanes(test);
    for (std::size_t c = 0; c < a.size(); ++c) maps.push_back(ssimTerms(a[c], b[c], edge).whole);
    return maps;
}

}  // namespace macula::image
