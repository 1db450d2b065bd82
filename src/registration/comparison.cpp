#include "registration/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "base/parallel.h"

namespace macula::registration {

namespace {

constexpr double kLeverMm = 100.0;  // rotations are measured in mm at this radius

}  // namespace

glm::dmat4 transformOf(const Parameters& p, const glm::dvec3& middleMm) {
    const glm::dvec3 turn = glm::dvec3(p[0], p[1], p[2]) / kLeverMm;
    const double angle = glm::length(turn);
    glm::dmat4 movingFromFixed = glm::translate(glm::dmat4(1.0), middleMm + glm::dvec3(p[3], p[4], p[5]));
    if (angle > 0.0) movingFromFixed = glm::rotate(movingFromFixed, angle, turn / angle);
    return glm::translate(movingFromFixed, -middleMm);
}

namespace {

constexpr std::size_t kPointsOfPart = 4096;

struct Part {
    std::array<double, std::size_t(kBins) * kBins> weights{};  // fixed * kBins + moving
    std::size_t counted = 0;
};

void add(Part& part, std::span<const SamplePoint> points, const ScalarGrid& moving, const IntensityBins& bins,
         const glm::dmat4& cellFromFixed) {
    for (const SamplePoint& point : points) {
        const float value = moving.at(transformPoint(cellFromFixed, point.mm));
        if (std::isnan(value)) continue;
        const double place = bins.of(value);
        const double floor = std::floor(place);
        const double t = place - floor;
        const double s = 1.0 - t;
        double* to = part.weights.data() + std::size_t(point.bin) * kBins + std::size_t(floor) - 1;
        to[0] += s * s * s / 6.0;
        to[1] += (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0;
        to[2] += (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0;
        to[3] += t * t * t / 6.0;
        ++part.counted;
    }
}

// The entropy of weights whose sum is `total`.
template <class Weights>
double entropy(const Weights& weights, double total) {
    double sum = 0.0;
    for (const double weight : weights)
        if (weight > 0.0) sum -= weight / total * std::log(weight / total);
    return sum;
}

}  // namespace

Likeness likenessOf(std::span<const SamplePoint> points, const ScalarGrid& moving, const IntensityBins& bins,
                    const glm::dmat4& movingFromFixed) {
    if (points.empty()) return {};
    const glm::dmat4 cellFromFixed = moving.gridFromWorld * movingFromFixed;
    std::vector<Part> parts((points.size() + kPointsOfPart - 1) / kPointsOfPart);
    const auto addPart = [&](std::size_t n) {
        const std::size_t first = n * kPointsOfPart;
        add(parts[n], points.subspan(first, std::min(kPointsOfPart, points.size() - first)), moving, bins,
            cellFromFixed);
    };
    if (parts.size() == 1) {
        addPart(0);  // a thread would cost more
    } else {
        parallelFor(parts.size(), addPart);
    }
    Part& all = parts.front();
    for (std::size_t n = 1; n < parts.size(); ++n) {
        for (std::size_t bin = 0; bin < all.weights.size(); ++bin) all.weights[bin] += parts[n].weights[bin];
        all.counted += parts[n].counted;
    }
    Likeness likeness{.overlap = double(all.counted) / double(points.size())};
    if (all.counted == 0) return likeness;
    std::array<double, kBins> ofFixed{};
    std::array<double, kBins> ofMoving{};
    for (std::size_t bin = 0; bin < all.weights.size(); ++bin) {
        ofFixed[bin / kBins] += all.weights[bin];
        ofMoving[bin % kBins] += all.weights[bin];
    }
    const auto total = double(all.counted);
    const double separate = entropy(ofFixed, total) + entropy(ofMoving, total);
    const double joint = entropy(all.weights, total);
    likeness.information = std::max(separate - joint, 0.0);
    if (joint > 0.0) likeness.normalised = separate / joint;
    return likeness;
}

namespace {

// SplitMix64: a 64-bit number for each counter.
std::uint64_t mixed(std::uint64_t counter) {
    std::uint64_t z = counter + 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
}

// A number from 0 (inclusive) to 1 (exclusive).
double share(std::uint64_t seed, std::uint64_t counter) {
    constexpr double kTo53Bits = 1.0 / 9007199254740992.0;
    return double(mixed(mixed(seed) + counter) >> 11U) * kTo53Bits;
}

}  // namespace

std::vector<SamplePoint> samplePoints(const ScalarGrid& grid, const IntensityBins& bins, std::size_t wanted,
                                      std::uint64_t seed) {
    const std::size_t cells = grid.values.size();
    const auto valid =
        std::size_t(std::ranges::count_if(grid.values, [](float value) { return !std::isnan(value); }));
    if (valid == 0 || wanted == 0) return {};
    // Draws more than wanted, because draws without a value are dropped.
    const std::size_t draws = std::min(cells, std::size_t(double(wanted) * double(cells) / double(valid)));
    std::vector<SamplePoint> points;
    points.reserve(std::min(wanted, draws) + 1);
    const auto width = std::size_t(grid.size.x);
    const auto height = std::size_t(grid.size.y);
    for (std::size_t n = 0; n < draws; ++n) {
        const double along = (double(n) + share(seed, 4 * n)) * double(cells) / double(draws);
        const std::size_t at = std::min(std::size_t(along), cells - 1);
        const std::size_t row = at / width;
        const std::size_t slice = row / height;
        const glm::dvec3 cell(double(at % width) + share(seed, 4 * n + 1),
                              double(row % height) + share(seed, 4 * n + 2),
                              double(slice) + share(seed, 4 * n + 3));
        const float value = grid.at(cell);
        if (std::isnan(value)) continue;
        points.push_back({transformPoint(grid.worldFromGrid, cell), int(std::lround(bins.of(value)))});
    }
    return points;
}

}  // namespace macula::registration
