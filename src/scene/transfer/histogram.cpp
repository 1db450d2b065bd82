#include "scene/transfer/histogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "base/check.h"

namespace macula::scene {

namespace {

constexpr std::size_t kMostBins = 16384;
constexpr std::size_t kBetweenLooks = 1 << 16;  // voxels between checks of the token
constexpr double kEdge = 1e-9;                  // fraction of a bin

std::size_t strideFor(const Volume& volume, std::size_t most) {
    std::size_t stride = (volume.voxelCount() + most - 1) / most;
    if (stride <= 1) return 1;
    const glm::ivec3 size = volume.size();
    const auto isInStep = [&] {
        return std::ranges::any_of(std::array{size.x, size.y, size.z},
                                   [&](int length) { return std::gcd(stride, std::size_t(length)) != 1; });
    };
    while (isInStep()) ++stride;
    return stride;
}

template <class T, class IsPadding, class ValueOf>
bool count(std::span<const T> voxels, const IsPadding& isPadding, const ValueOf& valueOf,
           const CancelToken& token, Histogram& histogram) {
    const auto [low, high] = histogram.bins.range;
    const std::size_t last = histogram.bins.count - 1;
    const double binsPerUnit = double(histogram.bins.count) / (high - low);
    std::size_t untilLook = 0;
    for (std::size_t i = 0; i < voxels.size(); i += histogram.stride) {
        if (untilLook-- == 0) {
            if (token.cancelled()) return false;
            untilLook = kBetweenLooks;
        }
        if (isPadding(voxels[i])) continue;
        const double value = valueOf(voxels[i]);
        if (value < low) {
            ++histogram.below;
        } else if (value > high) {
            ++histogram.above;
        } else {
            ++histogram.counts[std::min(last, std::size_t((value - low) * binsPerUnit))];
        }
    }
    return true;
}

}  // namespace

double Histogram::edge(std::size_t bin) const {
    return bins.range.low + (bins.range.high - bins.range.low) * double(bin) / double(bins.count);
}

std::optional<Bins> binsOf(const Volume& volume) {
    const std::optional<ValueRange> values = volume.valueRange();
    if (!values) return std::nullopt;
    if (volume.format() == VoxelFormat::float32) {
        if (values->low < values->high) return Bins{.range = *values, .count = kMostBins};
        const double half = std::max(0.5, std::abs(values->low) * 1e-6);
        return Bins{.range = {values->low - half, values->high + half}, .count = 1};
    }
    const StoredRange stored = volume.storedRange();
    const std::size_t steps = std::size_t(stored.high) - stored.low + 1;
    const std::size_t perBin = (steps + kMostBins - 1) / kMostBins;
    const std::size_t bins = (steps + perBin - 1) / perBin;
    // Edges lie halfway between stored values, so that no value lies on an edge.
    return Bins{.range = {volume.unitsFromStored()(stored.low - 0.5),
                          volume.unitsFromStored()(stored.low - 0.5 + double(bins * perBin))},
                .count = bins};
}

Result<Histogram> histogramOf(const Volume& volume, const Bins& bins, const CancelToken& token,
                              std::size_t most) {
    MACULA_CHECK(bins.range.low < bins.range.high && bins.count > 0 && most > 0);
    Histogram histogram{
        .bins = bins, .counts = std::vector<std::uint64_t>(bins.count, 0), .stride = strideFor(volume, most)};
    bool isWhole = false;
    if (volume.format() == VoxelFormat::float32) {
        const std::optional<float> padding = volume.floatPadding();
        isWhole = count(
            volume.floatVoxels(), [&](float voxel) { return std::isnan(voxel) || voxel == padding; },
            [](float voxel) { return double(voxel); }, token, histogram);
    } else {
        const std::optional<StoredRange> padding = volume.padding();
        isWhole = count(
            volume.voxels(), [&](std::uint16_t voxel) { return padding && padding->contains(voxel); },
            [units = volume.unitsFromStored()](std::uint16_t voxel) { return units(voxel); }, token,
            histogram);
    }
    if (!isWhole) return Error{ErrorCode::cancelled, Text("The values were not counted."), {}, {}};
    return histogram;
}

double percentile(const Histogram& histogram, double fraction) {
    const std::uint64_t inBins =
        std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t(0));
    const double wanted = std::clamp(fraction, 0.0, 1.0) * double(histogram.below + inBins + histogram.above);
    double below = double(histogram.below);
    std::size_t bin = 0;
    while (bin < histogram.counts.size() && below < wanted) below += double(histogram.counts[bin++]);
    return histogram.edge(bin);
}

std::vector<double> logHeights(const Histogram& histogram, const ValueRange& shown, std::size_t columns) {
    std::vector<double> heights(columns, 0.0);
    if (histogram.counts.empty() || !(shown.low < shown.high)) return heights;
    const std::uint64_t highest = *std::ranges::max_element(histogram.counts);
    if (highest == 0) return heights;
    const double bins = double(histogram.counts.size());
    const ValueRange range = histogram.bins.range;
    const auto binAt = [&](double column) {
        const double value = shown.low + (shown.high - shown.low) * column / double(columns);
        return std::clamp((value - range.low) / (range.high - range.low) * bins, 0.0, bins);
    };
    for (std::size_t column = 0; column < columns; ++column) {
        const double from = binAt(double(column));
        const double to = binAt(double(column) + 1.0);
        if (to <= 0.0 || from >= bins) continue;  // outside all bins
        // kEdge keeps an edge that was rounded from touching the next bin.
        const std::size_t first =
            std::min(histogram.counts.size() - 1, std::size_t(std::floor(from + kEdge)));
        const auto end = std::max(first + 1, std::size_t(std::ceil(to - kEdge)));
        const std::uint64_t most = *std::max_element(histogram.counts.begin() + std::ptrdiff_t(first),
                                                     histogram.counts.begin() + std::ptrdiff_t(end));
        heights[column] = std::log1p(double(most)) / std::log1p(double(highest));
    }
    return heights;
}

}  // namespace macula::scene
