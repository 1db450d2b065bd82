#include "image/metrics.h"

#include <cmath>
#include <limits>

#include "image/planes.h"

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

Result<double> psnr(const Image& reference, const Image& test) {
    MACULA_TRY_VOID(comparable(reference, test));
    const auto a = colourPlanes(reference);
    const auto b = colourPlanes(test);
    double squares = 0.0;
    for (std::size_t c = 0; c < a.size(); ++c) {
        for (std::size_t i = 0; i < a[c].values.size(); ++i) {
            const double difference = a[c].values[i] - b[c].values[i];
            squares += difference * difference;
        }
    }
    if (squares == 0.0) return std::numeric_limits<double>::infinity();
    return -10.0 * std::log10(squares / double(a.size() * a.front().values.size()));
}

Result<double> ssim(const Image& reference, const Image& test) {
    MACULA_TRY_VOID(comparable(reference, test));
    constexpr double kC1 = 0.01 * 0.01;
    constexpr double kC2 = 0.03 * 0.03;
    const auto a = colourPlanes(reference);
    const auto b = colourPlanes(test);
    const std::vector<double> window = ssimWindow();
    const auto blur = [&](const Plane& plane) { return filter(plane, window, window, Edge::cut); };
    double sum = 0.0;
    for (std::size_t c = 0; c < a.size(); ++c) {
        const Plane meanA = blur(a[c]);
        const Plane meanB = blur(b[c]);
        const Plane squareA = blur(product(a[c], a[c]));
        const Plane squareB = blur(product(b[c], b[c]));
        const Plane cross = blur(product(a[c], b[c]));
        for (std::size_t i = 0; i < meanA.values.size(); ++i) {
            const double ma = meanA.values[i];
            const double mb = meanB.values[i];
            const double va = squareA.values[i] - ma * ma;
            const double vb = squareB.values[i] - mb * mb;
            const double vab = cross.values[i] - ma * mb;
            sum += (2 * ma * mb + kC1) * (2 * vab + kC2) / ((ma * ma + mb * mb + kC1) * (va + vb + kC2));
        }
    }
    return sum / double(a.size() * a.front().values.size());
}

}  // namespace macula::image
