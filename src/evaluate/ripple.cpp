#include "evaluate/ripple.h"

#include <cmath>
#include <cstddef>

#include "base/check.h"

namespace macula::evaluate {

namespace {

constexpr int kDegree = 6;

double dotOf(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

void takeAway(std::vector<double>& from, const std::vector<double>& unit) {
    const double part = dotOf(from, unit);
    for (std::size_t i = 0; i < from.size(); ++i) from[i] -= part * unit[i];
}

// Polynomials of the coordinates, orthonormal over the counting pixels (Gram-Schmidt).
std::vector<std::vector<double>> smoothBasis(std::span<const double> xs, std::span<const double> ys) {
    std::vector<std::vector<double>> basis;
    for (int degree = 0; degree <= kDegree; ++degree) {
        for (int power = 0; power <= degree; ++power) {
            std::vector<double> next(xs.size());
            for (std::size_t i = 0; i < xs.size(); ++i)
                next[i] = std::pow(xs[i], power) * std::pow(ys[i], degree - power);
            // Twice, because of rounding errors with nearly parallel vectors.
            for (int turn = 0; turn < 2; ++turn) {
                for (const auto& before : basis) takeAway(next, before);
            }
            const double length = std::sqrt(dotOf(next, next));
            MACULA_CHECK(length > 0.0);
            for (double& value : next) value /= length;
            basis.push_back(std::move(next));
        }
    }
    return basis;
}

}  // namespace

Ripple rippleOf(const LuminancePicture& a, const LuminancePicture& b, std::span<const std::uint8_t> counts) {
    MACULA_CHECK(a.width == b.width && a.height == b.height && counts.size() == a.luminance.size());
    std::vector<double> xs;
    std::vector<double> ys;
    std::vector<double> ofA;
    std::vector<double> ofB;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(a.width) + std::size_t(x);
            if (counts[i] == 0) continue;
            xs.push_back(2.0 * (x + 0.5) / a.width - 1.0);
            ys.push_back(2.0 * (y + 0.5) / a.height - 1.0);
            ofA.push_back(a.luminance[i]);
            ofB.push_back(b.luminance[i]);
        }
    }
    MACULA_CHECK(ofA.size() >= 64);
    Ripple ripple;
    for (std::size_t i = 0; i < ofA.size(); ++i) ripple.mean += 0.5 * (ofA[i] + ofB[i]) / double(ofA.size());
    if (!(ripple.mean > 0.0)) return ripple;
    const auto basis = smoothBasis(xs, ys);
    for (const auto& smooth : basis) {
        takeAway(ofA, smooth);
        takeAway(ofB, smooth);
    }
    const double free = double(ofA.size() - basis.size());
    const double shared = dotOf(ofA, ofB) / free;
    ripple.relative = std::sqrt(std::max(shared, 0.0)) / ripple.mean;
    // The standard error of the mean product of independent noise over so many pixels.
    const double noiseA = std::max(dotOf(ofA, ofA) / free - std::max(shared, 0.0), 0.0);
    const double noiseB = std::max(dotOf(ofB, ofB) / free - std::max(shared, 0.0), 0.0);
    ripple.least = std::pow(noiseA * noiseB / free, 0.25) / ripple.mean;
    return ripple;
}

}  // namespace macula::evaluate
